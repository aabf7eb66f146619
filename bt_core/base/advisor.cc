#include "bt_core/base/advisor.h"

namespace coppice {
namespace {

constexpr std::size_t kMostCompared = 500'000'000;  // letters with letters: a second
constexpr std::size_t kOfAName = 100;               // takes as long to copy

}  // namespace

bool Advisor::MayCompare(std::string_view name, std::size_t candidates) {
  if (compared_ > kMostCompared) return false;
  compared_ += candidates * (kOfAName + name.size() * name.size());
  return true;
}

}  // namespace coppice
