#include "robot_app/simulation/bodies.h"

#include <box2d/box2d.h>

namespace coppice::robot::simulation {
namespace {

constexpr float kFriction = 0.3F;

b2Vec2 ToBox2D(Vec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
Vec2 FromBox2D(const b2Vec2& v) { return {v.x, v.y}; }

}  // namespace

struct Bodies::Box2D {
  Box2D() : world(b2Vec2(0, 0)) {
    const b2BodyDef def;
    ground = world.CreateBody(&def);
  }

  b2Fixture* AddEdge(const Segment& segment) {
    b2EdgeShape shape;
    shape.SetTwoSided(ToBox2D(segment.a), ToBox2D(segment.b));
    return AddShape(shape);
  }

  b2Fixture* AddRectangle(const Rectangle& r) {
    b2PolygonShape shape;
    shape.SetAsBox(static_cast<float>(r.size.x / 2), static_cast<float>(r.size.y / 2),
                   ToBox2D(r.center), static_cast<float>(r.yaw));
    return AddShape(shape);
  }

  b2Fixture* AddTriangle(const Triangle& triangle) {
    b2PolygonShape shape;
    const std::array<b2Vec2, 3> corners = {ToBox2D(triangle[0]), ToBox2D(triangle[1]),
                                           ToBox2D(triangle[2])};
    shape.Set(corners.data(), static_cast<int>(corners.size()));
    return AddShape(shape);
  }

  b2Fixture* AddShape(const b2Shape& shape) {
    b2FixtureDef def;
    def.shape = &shape;
    def.friction = kFriction;
    return ground->CreateFixture(&def);
  }

  // Slot `i` of a list of fixtures that come and go.
  void Replace(std::vector<b2Fixture*>& slots, std::size_t i, b2Fixture* fixture) {
    if (slots.size() <= i) slots.resize(i + 1, nullptr);
    if (slots[i] != nullptr) ground->DestroyFixture(slots[i]);
    slots[i] = fixture;
    robot->SetAwake(true);
  }

  b2Body* AddDisc(b2BodyType type, Vec2 center, double radius) {
    b2BodyDef def;
    def.type = type;
    def.position = ToBox2D(center);
    def.allowSleep = false;
    b2Body* body = world.CreateBody(&def);
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(radius);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = kFriction;
    fixture.density = static_cast<float>(kRobotMass / (kPi * radius * radius));
    body->CreateFixture(&fixture);
    return body;
  }

  b2World world;
  b2Body* ground = nullptr;
  b2Body* robot = nullptr;
  std::vector<b2Fixture*> doors;
  std::vector<b2Fixture*> places;
  std::vector<b2Fixture*> landmark;  // one, or none yet
  std::vector<b2Body*> people;
  Velocity velocity;
};

Bodies::Bodies(const Floor& floor, const Pose2& start, double radius)
    : box2d_(std::make_unique<Box2D>()) {
  for (const auto* walls : {&floor.walls, &floor.glass}) {
    for (const auto& wall : *walls) {
      for (std::size_t i = 1; i < wall.size(); ++i) box2d_->AddEdge({wall[i - 1], wall[i]});
    }
  }
  for (const FloorBox& box : floor.furniture) box2d_->AddRectangle(box.shape);
  box2d_->robot = box2d_->AddDisc(b2_dynamicBody, start.position(), radius);
  box2d_->robot->SetBullet(true);
  // The wheels alone turn the robot; friction at its rim does not.
  box2d_->robot->SetFixedRotation(true);
  box2d_->robot->SetTransform(ToBox2D(start.position()), static_cast<float>(start.yaw));
}

Bodies::~Bodies() = default;

void Bodies::SetDoor(std::size_t i, const std::optional<Segment>& leaf) {
  box2d_->Replace(box2d_->doors, i, leaf ? box2d_->AddEdge(*leaf) : nullptr);
}

void Bodies::SetPlace(std::size_t i, const std::optional<Rectangle>& box) {
  box2d_->Replace(box2d_->places, i, box ? box2d_->AddRectangle(*box) : nullptr);
}

void Bodies::SetLandmark(const std::optional<Triangle>& landmark) {
  box2d_->Replace(box2d_->landmark, 0, landmark ? box2d_->AddTriangle(*landmark) : nullptr);
}

void Bodies::SetPerson(std::size_t i, const Disc& disc, double dt) {
  if (box2d_->people.size() <= i) {
    box2d_->people.push_back(box2d_->AddDisc(b2_kinematicBody, disc.center, disc.radius));
  }
  b2Body* body = box2d_->people[i];
  const Vec2 way = disc.center - FromBox2D(body->GetPosition());
  body->SetLinearVelocity(ToBox2D(way * (1 / dt)));
}

void Bodies::PutRobot(const Pose2& pose) {
  b2Body& robot = *box2d_->robot;
  robot.SetTransform(ToBox2D(pose.position()), static_cast<float>(pose.yaw));
  robot.SetLinearVelocity(b2Vec2(0, 0));
  robot.SetAngularVelocity(0);
  box2d_->velocity = {};
}

void Bodies::Step(double dt, const Velocity& velocity) {
  b2Body& robot = *box2d_->robot;
  const Pose2 before = this->robot();
  // The chord of the arc that the wheels describe.
  const double heading = before.yaw + velocity.angular * dt / 2;
  robot.SetLinearVelocity(ToBox2D(Direction(heading) * velocity.linear));
  robot.SetAngularVelocity(static_cast<float>(velocity.angular));
  box2d_->world.Step(static_cast<float>(dt), 8, 3);
  const Vec2 moved = this->robot().position() - before.position();
  box2d_->velocity = {Dot(moved, Direction(heading)) / dt, robot.GetAngularVelocity()};
}

Pose2 Bodies::robot() const {
  const b2Vec2 position = box2d_->robot->GetPosition();
  return {position.x, position.y, NormalAngle(box2d_->robot->GetAngle())};
}

Velocity Bodies::velocity() const { return box2d_->velocity; }

bool Bodies::touching() const {
  for (const b2ContactEdge* edge = box2d_->robot->GetContactList(); edge; edge = edge->next) {
    if (edge->contact->IsTouching()) return true;
  }
  return false;
}

}  // namespace coppice::robot::simulation
