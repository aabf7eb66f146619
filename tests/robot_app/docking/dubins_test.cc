#include "robot_app/docking/dubins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace coppice::robot::docking {
namespace {

Pose2D RandomPose(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> place(-reach, reach);
  std::uniform_real_distribution<double> angle(-M_PI, M_PI);
  return {place(random), place(random), angle(random)};
}

double Missing(const Pose2D& a, const Pose2D& b) {
  return Distance(a, b) + std::abs(NormalizeAngle(a.yaw - b.yaw));
}

TEST(Dubins, EveryWordThatIsGivenLeadsToTheGoal) {
  std::mt19937 random(1);
  std::set<std::string> words;
  for (int i = 0; i < 20000; ++i) {
    const Pose2D from = RandomPose(random, 3);
    const Pose2D to = RandomPose(random, 3);
    const auto paths = DubinsPaths(from, to, 0.7);
    ASSERT_FALSE(paths.empty());
    for (const DubinsPath& path : paths) {
      ASSERT_LT(Missing(path.At(path.length()), to), 1e-5) << path.word() << ' ' << i;
      words.insert(path.word());
    }
  }
  EXPECT_EQ(words, (std::set<std::string>{"LSL", "RSR", "LSR", "RSL", "RLR", "LRL"}));
}

// Brute force: whatever sequence of arcs and straight stretches a vehicle drives, Dubins' way to
// where it has come is not longer.
TEST(Dubins, NoWayThatIsDrivenIsShorter) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> length(0, 3);
  std::uniform_int_distribution<int> turn(-1, 1);
  std::uniform_int_distribution<int> count(1, 5);
  constexpr double kRadius = 0.5;
  for (int i = 0; i < 200000; ++i) {
    const Pose2D from = RandomPose(random, 1);
    Pose2D at = from;
    double driven = 0;
    for (int part = count(random); part > 0; --part) {
      const double way = length(random);
      at = Advance(at, {1, turn(random) / kRadius}, way);
      driven += way;
    }
    const DubinsPath path = DubinsPaths(from, at, kRadius).front();
    ASSERT_LE(path.length(), driven + 1e-6) << path.word() << ' ' << i;
    ASSERT_GE(path.length(), Distance(from, at) - 1e-9);
  }
}

// And all ways of three parts on a fine grid of their lengths.
TEST(Dubins, NoWayOfThreePartsIsShorter) {
  constexpr int kSteps = 24;
  for (const int first : {1, -1}) {
    for (const int second : {1, 0, -1}) {
      for (const int third : {1, -1}) {
        for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
          const double a = 2 * M_PI * (i % kSteps) / kSteps;
          const double b = 2 * M_PI * (i / kSteps % kSteps) / kSteps;
          const double c = 2 * M_PI * (i / kSteps / kSteps) / kSteps;
          const Pose2D to = Advance(Advance(Advance({}, {1, 1.0 * first}, a), {1, 1.0 * second}, b),
                                    {1, 1.0 * third}, c);
          ASSERT_LE(DubinsPaths({}, to, 1).front().length(), a + b + c + 1e-6);
        }
      }
    }
  }
}

TEST(Dubins, EachWordIsTheShortestSomewhere) {
  std::mt19937 random(3);
  std::set<std::string> shortest;
  for (int i = 0; i < 20000; ++i) {
    shortest.insert(
        DubinsPaths(RandomPose(random, 1.5), RandomPose(random, 1.5), 1).front().word());
  }
  EXPECT_EQ(shortest.size(), 6U);
}

TEST(Dubins, TheShortestComesFirst) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const auto paths = DubinsPaths(RandomPose(random, 2), RandomPose(random, 2), 0.5);
    for (std::size_t k = 1; k < paths.size(); ++k) {
      EXPECT_LE(paths[k - 1].length(), paths[k].length());
    }
  }
}

TEST(Dubins, StraightAheadIsStraight) {
  const auto paths = DubinsPaths({1, 1, M_PI / 2}, {1, 4, M_PI / 2}, 0.5);
  EXPECT_NEAR(paths.front().length(), 3, 1e-9);
  EXPECT_NEAR(paths.front().At(2).y, 3, 1e-9);
}

TEST(Dubins, WhereItStandsAlreadyItDoesNotGoRound) {
  EXPECT_NEAR(DubinsPaths({2, 1, 0.3}, {2, 1, 0.3}, 0.5).front().length(), 0, 1e-6);
}

TEST(Dubins, NowhereIsItTighterThanTheRadius) {
  std::mt19937 random(5);
  for (int i = 0; i < 200; ++i) {
    const DubinsPath path = DubinsPaths(RandomPose(random, 2), RandomPose(random, 2), 0.5).front();
    for (double way = 0; way + 0.01 < path.length(); way += 0.01) {
      const double turn = NormalizeAngle(path.At(way + 0.01).yaw - path.At(way).yaw);
      ASSERT_LE(std::abs(turn), 0.01 / 0.5 + 1e-9);
    }
  }
}

}  // namespace
}  // namespace coppice::robot::docking
