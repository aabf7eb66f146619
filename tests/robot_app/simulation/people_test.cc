#include "robot_app/simulation/people.h"

#include <gtest/gtest.h>

#include "tests/robot_app/simulation/test_floor.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kDt = 0.02;
const Disc kNobody{{1000, 1000}, 0.33};

Walker ToAndFro() { return {"anna", 1.0, {{0, 0}, {10, 0}}}; }

TEST(People, WalkTheirRoundAtTheirSpeed) {
  People people({ToAndFro()});
  for (double t = 0; t < 5 - 1e-9; t += kDt) people.Step(kDt, kNobody, RayCaster());
  EXPECT_NEAR(people.discs()[0].center.x, 5, 0.03);
  for (double t = 0; t < 10; t += kDt) people.Step(kDt, kNobody, RayCaster());
  EXPECT_NEAR(people.discs()[0].center.x, 5, 0.1);  // on the way back
}

TEST(People, StopBeforeTheRobotAndThenTurnRound) {
  People people({ToAndFro()});
  const Disc robot{{5, 0}, 0.33};
  double nearest = 100;
  double waited = 0;
  double end = 0;
  for (double t = 0; t < 12; t += kDt) {
    const double before = people.discs()[0].center.x;
    people.Step(kDt, robot, RayCaster());
    end = people.discs()[0].center.x;
    if (end == before) waited += kDt;
    nearest = std::min(nearest, 5 - end - 0.33 - kPersonRadius);
  }
  EXPECT_GE(nearest, kPersonDistance - 1e-9);
  EXPECT_LT(nearest, kPersonDistance + 0.05);
  EXPECT_GE(waited, kPersonPatience - 0.1);
  EXPECT_LT(end, 3);  // and walks back
}

TEST(People, NeverComeNearerThanPoliteToADrivingRobot) {
  People people({ToAndFro()});
  Disc robot{{5, 0}, 0.33};
  double last_gap = 100;
  for (double t = 0; t < 5; t += kDt) {
    people.Step(kDt, robot, RayCaster());
    const double gap = robot.center.x - people.discs()[0].center.x - 0.33 - kPersonRadius;
    if (gap < 0) break;  // a real robot would have stopped
    if (gap < kPersonDistance) {
      EXPECT_GE(gap, last_gap - 1e-9);  // not by the person's own step
    }
    robot.center.x -= 0.5 * kDt;
    last_gap = gap - 0.5 * kDt;
  }
}

// The robot drives to a point at half a metre a second.
template <class After>
void DriveTo(Vec2 goal, Disc& robot, People& people, const RayCaster& still, const After& after) {
  while (Length(goal - robot.center) > 0.02) {
    robot.center = robot.center + (goal - robot.center) * (0.5 * kDt / Length(goal - robot.center));
    people.Step(kDt, robot, still);
    after();
  }
}

TEST(People, WhoFollowsWalksBehindTheRobotRoundACornerAndGoesBackToHisRound) {
  const RayCaster corner(Segments{{{4, 1}, {4, 20}}});  // the robot drives round its lower end
  People people({ToAndFro()});
  Disc robot{{2, 2}, 0.33};
  people.SetFollows(0, true);
  double farthest = 0;
  for (double t = 0; t < 5; t += kDt) people.Step(kDt, robot, corner);
  const auto watch = [&] {
    farthest = std::max(farthest, Length(robot.center - people.discs()[0].center));
  };
  DriveTo({2, 0}, robot, people, corner, watch);
  DriveTo({6, 0}, robot, people, corner, watch);
  DriveTo({6, 8}, robot, people, corner, watch);
  EXPECT_LT(farthest, 4) << "he has lost the robot";
  EXPECT_GT(people.discs()[0].center.x, 4) << "he came round the corner";
  people.SetFollows(0, false);
  for (double t = 0; t < 20; t += kDt) people.Step(kDt, robot, corner);
  EXPECT_NEAR(people.discs()[0].center.y, 0, 0.3) << "on his round again";
}

TEST(People, WhoStepsAsideGoesRoundARobotThatStands) {
  Walker walker = ToAndFro();
  walker.steps_aside = true;
  People people({walker});
  const Disc robot{{5, 0}, 0.33};
  const RayCaster corridor(Segments{{{-1, 1.25}, {11, 1.25}}, {{-1, -1.25}, {11, -1.25}}});
  double nearest = 100;
  double farthest = 0;
  for (double t = 0; t < 15; t += kDt) {
    people.Step(kDt, robot, corridor);
    const Vec2 at = people.discs()[0].center;
    nearest = std::min(nearest, Length(at - robot.center) - 0.33 - kPersonRadius);
    farthest = std::max(farthest, at.x);
    ASSERT_LT(std::abs(at.y), 1.25 - kPersonRadius);
  }
  EXPECT_GE(nearest, kPersonSqueezes - 1e-9);
  EXPECT_GT(farthest, 9);
}

TEST(People, WhoStepsAsideTurnsRoundWhereThereIsNoRoom) {
  Walker walker = ToAndFro();
  walker.steps_aside = true;
  People people({walker});
  const RayCaster corridor(Segments{{{-1, 0.8}, {11, 0.8}}, {{-1, -0.8}, {11, -0.8}}});
  double farthest = 0;
  for (double t = 0; t < 30; t += kDt) {
    people.Step(kDt, {{5, 0}, 0.33}, corridor);
    farthest = std::max(farthest, people.discs()[0].center.x);
  }
  EXPECT_LT(farthest, 5);
  EXPECT_LT(people.discs()[0].center.x, 4);
}

TEST(People, WhoStepsAsideKeepsAwayFromARobotThatDrives) {
  Walker walker = ToAndFro();
  walker.steps_aside = true;
  People people({walker});
  Disc robot{{9, 0}, 0.33};
  for (double t = 0; t < 12; t += kDt) {
    const double before = Length(people.discs()[0].center - robot.center);
    people.Step(kDt, robot, RayCaster());
    const double after = Length(people.discs()[0].center - robot.center);
    if (after < before) {
      ASSERT_GE(after - 0.33 - kPersonRadius, kPersonDistance - 1e-9);
    }
    robot.center.x -= 0.2 * kDt;
  }
}

TEST(People, StopBeforeAClosedDoor) {
  People people({ToAndFro()});
  const RayCaster door(Segments{{{4, -1}, {4, 1}}});
  for (double t = 0; t < 30; t += kDt) {
    people.Step(kDt, kNobody, door);
    ASSERT_LT(people.discs()[0].center.x, 4 - kPersonRadius);
  }
}

}  // namespace
}  // namespace coppice::robot::simulation
