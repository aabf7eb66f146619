#include "bt_core/testing/chances.h"

#include <algorithm>
#include <cmath>

namespace coppice {
namespace {

std::uint64_t Mix(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

// FNV-1a
std::uint64_t HashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

Status ResultOf(const Chances& chances, double number) {
  const double all = chances.success + chances.failure + chances.skipped;
  double place = number * all;
  if (all <= 0 || place < chances.success) return Status::kSuccess;
  place -= chances.success;
  return place < chances.failure ? Status::kFailure : Status::kSkipped;
}

Duration Between(Duration shortest, Duration longest, double part) {
  const auto range = static_cast<double>((longest - shortest).count());
  return shortest + Duration(std::llround(part * std::max(range, 0.0)));
}

}  // namespace

Dice::Dice(std::uint64_t seed, std::string_view who) : state_(Mix(seed) ^ HashOf(who)) {}

double Dice::Next() {
  state_ += 0x9e3779b97f4a7c15U;
  return static_cast<double>(Mix(state_) >> 11U) * 0x1p-53;
}

DrawnResult Throw(const Chances& chances, Dice& dice) {
  DrawnResult drawn;
  drawn.result = ResultOf(chances, dice.Next());
  const double part = dice.Next();
  if (drawn.result != Status::kSkipped) {
    drawn.after = Between(chances.shortest, chances.longest, part);
  }
  if (chances.longest_hold > Duration(0)) {
    drawn.holds = Between(chances.shortest_hold, chances.longest_hold, dice.Next());
  }
  return drawn;
}

}  // namespace coppice
