#include "robot_app/deployment/scenario/chance.h"

#include <cmath>
#include <numeric>

namespace coppice::robot::deployment {
namespace {

// FNV-1a.
std::uint64_t HashOf(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

}  // namespace

Chance::Chance(std::uint64_t seed, std::string_view stream)
    : bits_(HashOf(stream, 14695981039346656037u ^ (seed * 0x9E3779B97F4A7C15u))) {}

double Chance::Uniform() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }

double Chance::Exponential(double mean) { return -mean * std::log1p(-Uniform()); }

double Chance::LogNormal(double median, double sigma) {
  const double radius = std::sqrt(-2 * std::log1p(-Uniform()));  // Box and Muller
  return median * std::exp(sigma * radius * std::cos(2 * M_PI * Uniform()));
}

int Chance::Poisson(double mean) {
  int count = 0;
  for (double time = Exponential(1); time < mean; time += Exponential(1)) ++count;
  return count;
}

std::size_t Chance::Pick(const std::vector<double>& weights) {
  double left = Uniform() * std::accumulate(weights.begin(), weights.end(), 0.0);
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    left -= weights[i];
    if (left < 0) return i;
  }
  return weights.size() - 1;
}

}  // namespace coppice::robot::deployment
