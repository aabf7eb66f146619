// Chance that is the same on every machine: the generator of the standard library, whose numbers
// are fixed, and distributions of our own, because those of the standard library are not.
//
// Every kind of fault draws from a stream of its own, so that to leave one out moves no other.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CHANCE_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CHANCE_H_

#include <cstddef>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace coppice::robot::deployment {

class Chance {
 public:
  /// The stream of that name of a seed.
  Chance(std::uint64_t seed, std::string_view stream);

  double Uniform();  ///< [0, 1)
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  bool Happens(double probability) { return Uniform() < probability; }
  double Exponential(double mean);
  /// `sigma`: standard deviation of the logarithm.
  double LogNormal(double median, double sigma);
  int Poisson(double mean);
  /// Index of one of the weights, none of which is negative.
  std::size_t Pick(const std::vector<double>& weights);

 private:
  std::mt19937_64 bits_;
};

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_SCENARIO_CHANCE_H_
