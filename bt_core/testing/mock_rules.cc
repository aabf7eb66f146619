#include "bt_core/testing/mock_rules.h"

#include <algorithm>
#include <tuple>

namespace coppice {
namespace {

// In the order of their rank.
enum class PatternKind { kType, kName, kPath };

PatternKind KindOf(std::string_view pattern) {
  if (pattern.size() > 2 && pattern.front() == '<' && pattern.back() == '>') {
    return PatternKind::kType;
  }
  return pattern.find('/') == std::string_view::npos ? PatternKind::kName : PatternKind::kPath;
}

std::tuple<PatternKind, bool, std::ptrdiff_t> RankOf(std::string_view pattern) {
  const auto stars = std::count(pattern.begin(), pattern.end(), '*');
  return {KindOf(pattern), stars == 0, static_cast<std::ptrdiff_t>(pattern.size()) - stars};
}

}  // namespace

bool FitsWildcards(std::string_view pattern, std::string_view text) {
  std::size_t p = 0;
  std::size_t t = 0;
  std::size_t star = std::string_view::npos;  // the last one seen, and where its text ends so far
  std::size_t star_end = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_end = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++star_end;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool Matches(std::string_view pattern, const NodeNames& node) {
  switch (KindOf(pattern)) {
    case PatternKind::kType:
      return FitsWildcards(pattern.substr(1, pattern.size() - 2), node.id);
    case PatternKind::kName:
      return FitsWildcards(pattern, node.name);
    default:
      return FitsWildcards(pattern.substr(pattern.front() == '/' ? 1 : 0), node.path);
  }
}

std::optional<std::size_t> ChooseRule(const std::vector<MockRule>& rules, const NodeNames& node) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!Matches(rules[i].pattern, node)) continue;
    if (!best || RankOf(rules[i].pattern) > RankOf(rules[*best].pattern)) best = i;
  }
  return best;
}

}  // namespace coppice
