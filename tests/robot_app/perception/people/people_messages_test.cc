#include "robot_app/perception/people/people_messages.h"

#include <gtest/gtest.h>

#include <set>

namespace coppice::robot::perception {
namespace {

// Somebody without a mask walks along x at 1 m/s, seen for two seconds; somebody else only once.
Tracker Followed() {
  Tracker tracker;
  for (int i = 0; i < 20; ++i) {
    Detection walks;
    walks.position = {0.1 * i, 2};
    walks.covariance *= 0.01;
    walks.has_mask = false;
    tracker.Update(100 + 0.1 * i, {walks}, nullptr);
  }
  return tracker;
}

TEST(PeopleMessage, TellsWhoIsWhereAndHowFast) {
  const coppice_msgs::People people = ToMessage(Followed(), "odom");
  EXPECT_EQ(people.header.frame_id, "odom");
  EXPECT_NEAR(people.header.stamp.toSec(), 101.9, 1e-6);
  ASSERT_EQ(people.people.size(), 1U);
  EXPECT_NEAR(people.people[0].position.x, 1.9, 0.1);
  EXPECT_NEAR(people.people[0].velocity.x, 1, 0.1);
  EXPECT_NEAR(people.people[0].known_for, 1.9, 1e-3);
  EXPECT_EQ(people.people[0].unseen_for, 0);
  EXPECT_EQ(people.people[0].seen_by, coppice_msgs::Person::LIDAR);
  EXPECT_EQ(people.people[0].mask, coppice_msgs::Person::WITHOUT_MASK);
}

TEST(PeopleMessage, WhoIsOnlySuspectedIsNotInIt) {
  Tracker tracker;
  tracker.Update(100, {Detection()}, nullptr);
  EXPECT_TRUE(ToMessage(tracker, "odom").people.empty());
}

TEST(PeopleMarkers, EverybodyHasABodyANumberAndAWayOfHisOwn) {
  const auto markers = ToMarkers(ToMessage(Followed(), "odom")).markers;
  std::set<std::string> kinds;
  for (const auto& marker : markers) kinds.insert(marker.ns);
  EXPECT_EQ(kinds, (std::set<std::string>{"numbers", "people", "velocities"}));
  EXPECT_EQ(markers[0].header.frame_id, "odom");
}

}  // namespace
}  // namespace coppice::robot::perception
