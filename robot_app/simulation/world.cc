#include "robot_app/simulation/world.h"

#include "robot_app/simulation/safety_field.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kDockTolerance = 0.03;                // m
constexpr double kDockAngleTolerance = 3 * kPi / 180;  // rad
constexpr double kClearance = 0.05;          // kept between a new thing and who stands there, m
constexpr double kMaxStationOffset = 1;      // m
constexpr double kMaxStationTurn = kPi / 4;  // rad
constexpr double kLandmarkFromWall = 0.02;   // m
constexpr double kLargestFloor = 1000;       // m
constexpr double kSonarPeriod = 0.1;         // s
constexpr double kWeight = 150 * 9.81;       // of the robot [N]
constexpr double kTimeSlack = 1e-9;          // s; time is a sum of steps

// Every sensor draws its own noise, so that one more beam does not change the odometry.
std::uint64_t SeedOf(std::uint64_t seed, std::uint64_t sensor) { return seed * 16 + sensor; }

template <typename Item>
std::vector<std::string> Names(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.name);
  return names;
}

std::string Join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

// The index of the item with this name, or which names there are.
template <typename Item>
Expected<std::size_t> Find(const std::vector<Item>& items, const std::string& name,
                           const char* what) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].name == name) return i;
  }
  const std::vector<std::string> names = Names(items);
  const std::string hint = DidYouMean(name, names);
  return Problem{std::string("there is no ") + what + " \"" + name + "\"" +
                 (hint.empty() ? "; known: " + Join(names) : " (" + hint + ")")};
}

}  // namespace

World::World(const Floor& floor, const WorldOptions& options)
    : floor_(floor),
      ground_(floor.ground),
      radius_(options.radius),
      place_blocked_(floor.places.size(), false),
      bodies_(floor, options.start.value_or(floor.docked), options.radius),
      people_(floor.people),
      drive_(options.drive),
      battery_(options.battery, options.state_of_charge),
      lidar_(options.lidar, SeedOf(options.seed, 1)),
      lidar_3d_(options.lidar_3d, SeedOf(options.seed, 4)),
      odometry_(options.odometry, SeedOf(options.seed, 2)),
      imu_(SeedOf(options.seed, 3)) {
  for (std::size_t i = 0; i < floor.doors.size(); ++i) {
    door_open_.push_back(floor.doors[i].open);
    bodies_.SetDoor(i, DoorLeaf(floor.doors[i], floor.doors[i].open));
  }
  for (std::size_t i = 0; i < kSonars.size(); ++i) {
    sonars_.emplace_back(options.sonars[i], SeedOf(options.seed, 5 + i));
  }
  bodies_.SetLandmark(landmark());
  Rebuild();
  ShowPeople();
  ReadSensors();
}

void World::Step(double dt, const std::optional<Velocity>& command) {
  if (command) drive_.Command(time_, *command);
  MovePeople(dt);
  MoveRobot(dt);
  if (lidar_3d_on_) {
    scene_.SetFigures(figures_);
    lidar_3d_.Turn(time_, dt, robot(), scene_);
  }
  time_ += dt;
  ReadSensors();
}

void World::SetLidar3dOn(bool on) {
  if (on && !lidar_3d_on_) lidar_3d_.Restart();
  lidar_3d_on_ = on;
}

void World::MovePeople(double dt) {
  people_.Step(dt, robot_disc(), solid_);
  for (std::size_t i = 0; i < people_.discs().size(); ++i) {
    bodies_.SetPerson(i, people_.discs()[i], dt);
  }
  ShowPeople();
}

void World::ShowPeople() {
  figures_ = MakeFigures(people_.Stances());
  legs_ = SlicesAt(lidar_.options().height, figures_);
}

void World::MoveRobot(double dt) {
  const Velocity before = velocity();
  const Pose2 pose = robot();
  const double reach = drive_.ProtectiveField(drive_.options().max_linear) + 0.1;
  const double gap = FrontGap(pose, lidar_.options().mounting, radius_, reach, visible_, legs_);
  const bool powered = !battery_.empty() && !emergency_stop_;
  const Velocity wanted = drive_.Next(time_, dt, before, gap, powered);
  bodies_.Step(dt, wanted);
  const Velocity after = velocity();
  odometry_.Move(after.linear * dt, NormalAngle(robot().yaw - pose.yaw));
  imu_.Measure(dt, before, after);
  const double effort = std::max(std::abs(wanted.linear) / drive_.options().max_linear,
                                 std::abs(wanted.angular) / drive_.options().max_angular);
  const double uphill = after.linear * std::cos(robot().yaw) * ground_.Slope(robot().x);
  battery_.Step(dt, effort, docked() && charger_on_, kWeight * std::max(0.0, uphill));
}

void World::ReadSensors() {
  if (time_ + kTimeSlack >= next_scan_) {
    lidar_.Measure(time_, robot(), visible_, legs_, ground_);
    next_scan_ += lidar_.options().period;
    next_scan_ = std::max(next_scan_, time_ + kTimeSlack);
  }
  if (time_ + kTimeSlack >= next_odometry_) {
    odometry_.Read(time_);
    next_odometry_ += odometry_.options().period;
    next_odometry_ = std::max(next_odometry_, time_ + kTimeSlack);
  }
  if (time_ + kTimeSlack >= next_echoes_) {
    if (sonars_on_) ReadSonars();
    next_echoes_ += kSonarPeriod;
    next_echoes_ = std::max(next_echoes_, time_ + kTimeSlack);
  }
}

void World::ReadSonars() {
  audible_.SetFigures(figures_);
  echoes_.time = time_;
  for (std::size_t i = 0; i < sonars_.size(); ++i) {
    echoes_.ranges[i] = sonars_[i].Measure(robot(), audible_);
  }
}

std::optional<Triangle> World::landmark() const {
  return landmark_there_ ? LandmarkOf(floor_, station_moved_) : std::nullopt;
}

bool World::docked() const {
  if (!floor_.has_station) return false;
  const Pose2 contacts = Compose(station(), {0, contacts_offset_, 0});
  const Pose2 off = Compose(Inverse(contacts), robot());
  return Length(off.position()) <= kDockTolerance && std::abs(off.yaw) <= kDockAngleTolerance;
}

Pose2 World::OdomInMap() const { return Compose(robot(), Inverse(odometry_.pose())); }

void World::Rebuild() {
  scene_ = Scene(MakeStillScene(floor_, door_open_, place_blocked_, landmark()));
  visible_ = RayCaster(EdgesFrom(lidar_.options().height, still()));
  audible_ = Scene(WithGlass(still(), floor_));
  solid_ = RayCaster(EdgesFrom(0, audible_.still()));
}

// Who stands nearer to a thing than allowed; empty if nobody. `distance` is that of a point from
// it.
template <typename DistanceTo>
std::string World::WhoStandsNear(DistanceTo distance) const {
  if (distance(robot().position()) < radius_ + kClearance) return "the robot";
  for (std::size_t i = 0; i < people().size(); ++i) {
    if (distance(people()[i].center) < kPersonRadius + kClearance) return floor_.people[i].name;
  }
  return {};
}

Change World::SetPlaceBlocked(const std::string& place, bool blocked) {
  const auto i = Find(floor_.places, place, "place");
  if (!i) return Problem{i.problem()};
  const std::string state = blocked ? "blocked" : "clear";
  if (place_blocked_[*i] == blocked) return place + " is already " + state;
  const Rectangle& box = floor_.places[*i].shape;
  const std::string who = WhoStandsNear([&](Vec2 point) { return Distance(point, box); });
  if (blocked && !who.empty())
    return Problem{"cannot block " + place + ": " + who + " stands there"};
  place_blocked_[*i] = blocked;
  bodies_.SetPlace(*i, blocked ? std::optional(box) : std::nullopt);
  Rebuild();
  return place + " is " + state;
}

Change World::SetDoorOpen(const std::string& name, bool open) {
  const auto i = Find(floor_.doors, name, "door");
  if (!i) return Problem{i.problem()};
  const std::string state = open ? "open" : "closed";
  if (door_open_[*i] == open) return name + " is already " + state;
  const Door& door = floor_.doors[*i];
  const std::string who = WhoStandsNear([&](Vec2 point) { return DistanceFromSweep(door, point); });
  if (!who.empty()) {
    const std::string verb = open ? "cannot open " : "cannot close ";
    return Problem{verb + name + ": " + who + " stands in the way"};
  }
  door_open_[*i] = open;
  bodies_.SetDoor(*i, DoorLeaf(door, open));
  Rebuild();
  return name + " is " + state;
}

Change World::SetStateOfCharge(double state_of_charge) {
  if (!(state_of_charge >= 0 && state_of_charge <= 1)) {
    return Problem{"the state of charge must be 0..1, not " + std::to_string(state_of_charge)};
  }
  battery_.set_state_of_charge(state_of_charge);
  return "the battery holds " + std::to_string(std::lround(state_of_charge * 100)) + " %";
}

// Within walls, and nothing and nobody nearer than the robot is wide.
bool World::CanStandAt(Vec2 point) const {
  for (const double angle : {0.0, kPi / 2, kPi, 3 * kPi / 2}) {
    if (solid_.Cast(point, Direction(angle), kLargestFloor) >= kLargestFloor) return false;
  }
  for (const Segment& segment : solid_.segments()) {
    if (Distance(point, segment) < radius_) return false;
  }
  for (const FloorBox& box : floor_.furniture) {
    if (Distance(point, box.shape) <= 0) return false;
  }
  for (const Disc& person : people()) {
    if (Length(point - person.center) < radius_ + person.radius) return false;
  }
  return true;
}

Change World::Kidnap(const Pose2& pose) {
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.yaw)) {
    return Problem{"that is no pose"};
  }
  if (!CanStandAt(pose.position())) return Problem{"the robot cannot stand there"};
  bodies_.PutRobot(pose);
  return "the robot was put elsewhere";
}

// Who or what would be in the way of a landmark there; empty if nothing. A wall is if a robot that
// is docked at `docked` would see it before a corner of the landmark.
std::string World::WhatIsNear(const Triangle& landmark, Vec2 docked) const {
  for (const auto& wall : floor_.walls) {
    for (std::size_t i = 1; i < wall.size(); ++i) {
      for (const Vec2& corner : landmark) {
        const double reach = Length(corner - docked) + kLandmarkFromWall;
        const Vec2 way = (corner - docked) * (1 / Length(corner - docked));
        if (CastAtSegment({wall[i - 1], wall[i]}, docked, way, reach) < reach) return "a wall";
      }
    }
  }
  const auto sides = SidesOf(landmark);
  return WhoStandsNear([&](Vec2 point) {
    return std::min(
        {Distance(point, sides[0]), Distance(point, sides[1]), Distance(point, sides[2])});
  });
}

Change World::MoveStation(const Pose2& moved) {
  if (!floor_.has_station) return Problem{"the floor has no station"};
  if (!(std::hypot(moved.x, moved.y) <= kMaxStationOffset &&
        std::abs(moved.yaw) <= kMaxStationTurn)) {
    return Problem{"the station can be moved by 1 m and 45 degrees at most"};
  }
  if (const auto landmark = LandmarkOf(floor_, moved)) {
    const std::string what = WhatIsNear(*landmark, Compose(floor_.docked, moved).position());
    if (!what.empty()) return Problem{"cannot move the station: " + what + " is in the way"};
  }
  station_moved_ = moved;
  bodies_.SetLandmark(landmark());
  Rebuild();
  return "the station is " + std::to_string(std::lround(moved.x * 1000)) + " mm on, " +
         std::to_string(std::lround(moved.y * 1000)) + " mm to the left, turned by " +
         std::to_string(std::lround(moved.yaw * 180 / kPi)) + " degrees";
}

Change World::SetContactsOffset(double offset) {
  if (!(std::abs(offset) <= kMaxStationOffset)) {
    return Problem{"the contacts can be moved by 1 m at most"};
  }
  contacts_offset_ = offset;
  return "the contacts are " + std::to_string(std::lround(offset * 1000)) + " mm aside";
}

Change World::SetLandmark(bool there) {
  if (!floor_.has_station) return Problem{"the floor has no station"};
  landmark_there_ = there;
  bodies_.SetLandmark(landmark());
  Rebuild();
  return there ? "the landmark is there" : "the landmark is gone";
}

Change World::SetFollows(const std::string& person, bool follows) {
  const auto index = Find(floor_.people, person, "person");
  if (!index) return Problem{index.problem()};
  people_.SetFollows(*index, follows);
  return person + (follows ? " follows the robot" : " goes back");
}

Change World::SetChargerOn(bool on) {
  charger_on_ = on;
  return on ? "the charger is on" : "the charger is off";
}

Change World::SetEmergencyStop(bool pressed) {
  emergency_stop_ = pressed;
  return pressed ? "the emergency stop is pressed" : "the emergency stop is released";
}

}  // namespace coppice::robot::simulation
