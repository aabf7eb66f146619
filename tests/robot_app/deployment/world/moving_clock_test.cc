#include "robot_app/deployment/world/moving_clock.h"

#include <gmock/gmock.h>

#include "tests/robot_app/deployment/made_journal.h"

namespace coppice::robot::deployment {
namespace {

class MovingClockTest : public testing::Test {
 protected:
  static Scenario Days() {
    Scenario scenario;
    scenario.calendar = Calendar::Make(PublishedJournal().span, "24/7").value();
    return scenario;
  }
  void Pass(double seconds) {
    const Time end = world_.now() + Seconds(seconds);
    while (world_.now() < end) {
      world_.clock.Advance(std::min(end, world_.events.next()) - world_.now());
      world_.events.RunDue(world_.now());
    }
  }
  const Scenario scenario_ = Days();
  World world_{scenario_, 1};
  MovingClock clock_{world_};
  std::vector<int> rung_;
};

TEST_F(MovingClockTest, StandsWhileTheRobotDoesNotMove) {
  clock_.After(10, [this] { rung_.push_back(1); });
  Pass(100);
  EXPECT_TRUE(rung_.empty());
  clock_.SetMoving(true);
  Pass(6);
  clock_.SetMoving(false);
  Pass(100);
  EXPECT_TRUE(rung_.empty());
  clock_.SetMoving(true);
  Pass(4.001);
  EXPECT_EQ(rung_.size(), 1u);
  EXPECT_NEAR(clock_.seconds(), 10, 0.01);
}

TEST_F(MovingClockTest, RingsInTheOrderOfTimeAlsoForWhatWasPlannedWhileItRang) {
  clock_.SetMoving(true);
  clock_.After(5, [this] {
    rung_.push_back(5);
    clock_.After(1, [this] { rung_.push_back(6); });
  });
  clock_.After(7, [this] { rung_.push_back(7); });
  clock_.After(2, [this] { rung_.push_back(2); });
  Pass(8);
  EXPECT_THAT(rung_, testing::ElementsAre(2, 5, 6, 7));
}

TEST(EventQueue, HappensInTheOrderOfTimeAndOfPlanningAndNotWhenCancelled) {
  EventQueue queue;
  std::vector<int> happened;
  const auto note = [&](int number) { return [&happened, number] { happened.push_back(number); }; };
  queue.At(Time(std::chrono::seconds(2)), note(3));
  queue.At(Time(std::chrono::seconds(1)), note(1));
  queue.At(Time(std::chrono::seconds(1)), note(2));
  queue.Cancel(queue.At(Time(std::chrono::seconds(1)), note(9)));
  EXPECT_TRUE(queue.RunDue(Time(std::chrono::seconds(1))));
  EXPECT_THAT(happened, testing::ElementsAre(1, 2));
  EXPECT_EQ(queue.next(), Time(std::chrono::seconds(2)));
  EXPECT_FALSE(queue.RunDue(Time(std::chrono::seconds(1))));
}

}  // namespace
}  // namespace coppice::robot::deployment
