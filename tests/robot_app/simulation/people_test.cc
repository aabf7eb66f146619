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
