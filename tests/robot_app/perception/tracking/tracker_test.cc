#include "robot_app/perception/tracking/tracker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coppice::robot::perception {
namespace {

constexpr double kPeriod = 0.1;

Detection Seen(double x, double y, double probability = 0.95) {
  return {{x, y}, Eigen::Matrix2d::Identity() * 0.01, probability, Modality::kLidar, std::nullopt};
}

bool InPlainView(const Eigen::Vector2d&) { return false; }
bool Hidden(const Eigen::Vector2d&) { return true; }

std::vector<Track> Confirmed(const Tracker& tracker) {
  std::vector<Track> confirmed;
  for (const Track& track : tracker.tracks()) {
    if (track.is_confirmed) confirmed.push_back(track);
  }
  return confirmed;
}

// Somebody who walks along x at 1 m/s, seen ten times a second from `from` to `to`.
void Walk(Tracker& tracker, double from, double to) {
  for (double t = from; t < to; t += kPeriod) tracker.Update(t, {Seen(t, 2)}, InPlainView);
}

TEST(Tracker, OneSightingIsNobodyYet) {
  Tracker tracker;
  tracker.Update(0, {Seen(1, 1)}, InPlainView);
  EXPECT_TRUE(Confirmed(tracker).empty());
}

TEST(Tracker, WhoIsSeenAgainIsConfirmedWithinHalfASecond) {
  Tracker tracker;
  Walk(tracker, 0, 0.5);
  EXPECT_EQ(Confirmed(tracker).size(), 1U);
}

TEST(Tracker, WhatFlickersAtRandomPlacesIsNeverConfirmed) {
  Tracker tracker;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-5, 5);
  for (int i = 0; i < 300; ++i) {
    tracker.Update(i * kPeriod, {Seen(place(random), place(random), 0.6)}, InPlainView);
    EXPECT_TRUE(Confirmed(tracker).empty()) << i;
  }
}

TEST(Tracker, LearnsTheVelocity) {
  Tracker tracker;
  Walk(tracker, 0, 3);
  EXPECT_NEAR(Confirmed(tracker).at(0).velocity().x(), 1, 0.1);
  EXPECT_NEAR(Confirmed(tracker).at(0).velocity().y(), 0, 0.1);
}

TEST(Tracker, HoldsTheIdentityOverAnOcclusionOfTwoSeconds) {
  Tracker tracker;
  Walk(tracker, 0, 3);
  const std::uint32_t id = Confirmed(tracker).at(0).id;
  for (double t = 3; t < 5; t += kPeriod) tracker.Update(t, {}, Hidden);
  Walk(tracker, 5, 5.3);
  EXPECT_EQ(Confirmed(tracker).at(0).id, id);
}

TEST(Tracker, WhoIsGoneInPlainViewIsForgottenSooner) {
  Tracker tracker;
  Walk(tracker, 0, 3);
  for (double t = 3; t < 5.3; t += kPeriod) tracker.Update(t, {}, InPlainView);
  EXPECT_TRUE(tracker.tracks().empty());
}

TEST(Tracker, TwoWhoCrossKeepTheirNumbers) {
  Tracker tracker;
  const auto both = [&](double t) {
    tracker.Update(t, {Seen(t - 3, 0.3 * (t - 3)), Seen(3 - t, 0.3 * (t - 3) + 0.5)}, InPlainView);
  };
  for (double t = 0; t < 1; t += kPeriod) both(t);
  const auto before = Confirmed(tracker);
  for (double t = 1; t < 6; t += kPeriod) both(t);
  const auto after = Confirmed(tracker);
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(before[i].id, after[i].id);
    EXPECT_GT(before[i].velocity().x() * after[i].velocity().x(), 0) << "took the other one's way";
  }
}

TEST(Tracker, NamesTheSensorsThatSawThePersonWithinASecond) {
  Tracker tracker;
  Detection by_camera = Seen(1, 1);
  by_camera.modality = Modality::kCamera;
  for (double t = 0; t < 1; t += kPeriod) {
    tracker.Update(t, {Seen(1, 1)}, InPlainView);
    tracker.Update(t + 0.01, {by_camera}, InPlainView);
  }
  EXPECT_EQ(Confirmed(tracker).at(0).modalities, 3);
  for (double t = 1; t < 2.5; t += kPeriod) tracker.Update(t, {Seen(1, 1)}, InPlainView);
  EXPECT_EQ(Confirmed(tracker).at(0).modalities, 1);
}

TEST(Tracker, WhomTheLaserAloneSawIsForgottenAsSoonAsALidarsSuspect) {
  Tracker tracker;
  Detection legs = Seen(1, 1, 0.6);
  legs.modality = Modality::kLaser;
  tracker.Update(0, {legs}, InPlainView);
  EXPECT_EQ(tracker.tracks().at(0).modalities, 4);
  tracker.Update(0.3, {}, InPlainView);
  EXPECT_EQ(tracker.tracks().size(), 1U);
  tracker.Update(0.5, {}, InPlainView);
  EXPECT_TRUE(tracker.tracks().empty());
}

TEST(Tracker, AMaskIsBelievedOnceTwoFacesToldOfItAndRemembered) {
  Tracker tracker;
  Detection face = Seen(1, 1);
  face.has_mask = false;
  tracker.Update(0, {face}, InPlainView);
  EXPECT_FALSE(tracker.tracks().at(0).has_mask);
  tracker.Update(0.1, {face}, InPlainView);
  tracker.Update(0.2, {Seen(1, 1)}, InPlainView);
  EXPECT_EQ(tracker.tracks().at(0).has_mask, false);
}

TEST(Tracker, ARecordPlayedAgainBeginsAnew) {
  Tracker tracker;
  Walk(tracker, 100, 103);
  tracker.Update(0, {Seen(1, 1)}, InPlainView);
  ASSERT_EQ(tracker.tracks().size(), 1U);
  EXPECT_FALSE(tracker.tracks()[0].is_confirmed);
}

TEST(Tracker, WhatIsToldLateCountsForWhereSomebodyWasThen) {
  Tracker on_time, late;
  Walk(on_time, 0, 2);
  Walk(late, 0, 2);
  const double now = 2 - kPeriod;
  const Track before = on_time.tracks().at(0);
  const Eigen::Vector2d then = before.position() - 0.5 * before.velocity();
  late.Update(now - 0.5, {Seen(then.x(), then.y())}, InPlainView);
  ASSERT_EQ(late.tracks().size(), 1U);
  EXPECT_LT((late.tracks()[0].position() - before.position()).norm(), 0.01);
}

TEST(Tracker, WhatIsToldMuchTooLateIsIgnored) {
  Tracker tracker;
  Walk(tracker, 0, 3);
  tracker.Update(1, {Seen(9, 9)}, InPlainView);
  EXPECT_EQ(tracker.tracks().size(), 1U);
}

}  // namespace
}  // namespace coppice::robot::perception
