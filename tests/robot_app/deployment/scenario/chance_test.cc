#include "robot_app/deployment/scenario/chance.h"

#include <gtest/gtest.h>

namespace coppice::robot::deployment {
namespace {

TEST(Chance, IsTheSameForTheSameSeedAndStreamAndAnotherForAnother) {
  Chance one(7, "docking"), same(7, "docking"), seed(8, "docking"), stream(7, "network");
  const double first = one.Uniform();
  EXPECT_EQ(first, same.Uniform());
  EXPECT_NE(first, seed.Uniform());
  EXPECT_NE(first, stream.Uniform());
}

// On every machine: a number that was written down once.
TEST(Chance, DoesNotDependOnTheStandardLibrary) {
  Chance chance(1, "test");
  EXPECT_DOUBLE_EQ(chance.Uniform(), Chance(1, "test").Uniform());
  std::mt19937_64 bits(5489u);
  for (int i = 0; i < 9999; ++i) bits();
  EXPECT_EQ(bits(), 9981545732273789042u) << "as the standard says of its generator";
}

TEST(Chance, DistributionsHaveTheMeansThatTheyShould) {
  Chance chance(3, "means");
  double exponential = 0, poisson = 0;
  int below_median = 0, second = 0;
  constexpr int kTrials = 20000;
  for (int i = 0; i < kTrials; ++i) {
    exponential += chance.Exponential(4) / kTrials;
    poisson += chance.Poisson(2.5) / double{kTrials};
    below_median += chance.LogNormal(300, 0.8) < 300;
    second += chance.Pick({1, 3}) == 1;
  }
  EXPECT_NEAR(exponential, 4, 0.15);
  EXPECT_NEAR(poisson, 2.5, 0.06);
  EXPECT_NEAR(below_median, kTrials / 2, 300);
  EXPECT_NEAR(second, kTrials * 3 / 4, 300);
}

}  // namespace
}  // namespace coppice::robot::deployment
