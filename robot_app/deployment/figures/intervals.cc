#include "robot_app/deployment/figures/intervals.h"

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace coppice::robot::deployment {
namespace {

constexpr double kLow = 0.025, kHigh = 0.975;

// Probability of at most `count` with that mean.
double AtMost(int count, double mean) {
  double term = std::exp(-mean), sum = term;
  for (int i = 1; i <= count; ++i) sum += term *= mean / i;
  return sum;
}

int QuantileOf(double mean, double share) {
  int count = 0;
  while (AtMost(count, mean) < share) ++count;
  return count;
}

double ChiSquared(int degrees, double share) {
  return boost::math::quantile(boost::math::chi_squared(degrees), share);
}

double Beta(double a, double b, double share) {
  return boost::math::quantile(boost::math::beta_distribution<>(a, b), share);
}

}  // namespace

Bounds MeanOfCount(int count) {
  return {count == 0 ? 0 : ChiSquared(2 * count, kLow) / 2, ChiSquared(2 * count + 2, kHigh) / 2};
}

Bounds CountsOfMean(double mean) {
  return {static_cast<double>(QuantileOf(mean, kLow)),
          static_cast<double>(QuantileOf(mean, kHigh))};
}

Bounds ShareOf(int count, int trials) {
  if (trials == 0) return {0, 1};
  return {count == 0 ? 0 : Beta(count, trials - count + 1, kLow),
          count == trials ? 1 : Beta(count + 1, trials - count, kHigh)};
}

}  // namespace coppice::robot::deployment
