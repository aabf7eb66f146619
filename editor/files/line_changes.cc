#include "editor/files/line_changes.h"

#include <algorithm>

namespace coppice::editor {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::size_t kMostDifferences = 1000;  // beyond it the middle is one hunk
constexpr std::size_t kMostLines = 1'000'000;   // of both; beyond it all is one

std::size_t CountLines(std::string_view text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

Lines SplitLines(std::string_view text) {
  Lines lines;
  std::size_t start = 0;
  for (std::size_t end; (end = text.find('\n', start)) != std::string_view::npos; start = end + 1) {
    lines.push_back(text.substr(start, end - start));
  }
  lines.push_back(text.substr(start));
  return lines;
}

// The middle of two texts, whose ends are equal.
class Comparer {
 public:
  Comparer(const Lines& before, const Lines& after) : before_(before), after_(after) {
    while (begin_ < std::min(before.size(), after.size()) && before[begin_] == after[begin_]) {
      ++begin_;
    }
    before_end_ = before.size();
    after_end_ = after.size();
    while (before_end_ > begin_ && after_end_ > begin_ &&
           before[before_end_ - 1] == after[after_end_ - 1]) {
      --before_end_;
      --after_end_;
    }
  }

  std::vector<LineHunk> Run() {
    if (before_end_ == begin_ && after_end_ == begin_) return {};
    if (before_end_ == begin_ || after_end_ == begin_ || !Search()) {
      return {{begin_, before_end_, begin_, after_end_}};
    }
    return Hunks();
  }

 private:
  using Index = std::ptrdiff_t;

  // furthest_[d][k + d]: how far into `before` one comes on diagonal k with d differences.
  bool Search() {
    const auto n = static_cast<Index>(before_end_ - begin_);
    const auto m = static_cast<Index>(after_end_ - begin_);
    const auto most = std::min(static_cast<Index>(kMostDifferences), n + m);
    for (Index d = 0; d <= most; ++d) {
      furthest_.emplace_back(static_cast<std::size_t>(2 * d + 1), Index{-1});
      for (Index k = -d; k <= d; k += 2) {
        Index x = d == 0 ? 0 : Came(d, k);
        if (x < 0 || x > n || x - k > m) continue;
        while (x < n && x - k < m && Equal(x, x - k)) ++x;
        furthest_.back()[static_cast<std::size_t>(k + d)] = x;
        if (x == n && x - k == m) return true;
      }
    }
    return false;
  }

  // From above: a line of `after` more. From the left: a line of `before` less.
  Index Came(Index d, Index k) const {
    const Index down = At(d - 1, k + 1);
    const Index right = At(d - 1, k - 1);
    return std::max(down, right < 0 ? Index{-1} : right + 1);
  }

  Index At(Index d, Index k) const {
    if (k < -d || k > d) return -1;
    return furthest_[static_cast<std::size_t>(d)][static_cast<std::size_t>(k + d)];
  }

  bool Equal(Index x, Index y) const {
    return before_[begin_ + static_cast<std::size_t>(x)] ==
           after_[begin_ + static_cast<std::size_t>(y)];
  }

  // Walks the way back and gathers steps without equal lines between them.
  std::vector<LineHunk> Hunks() const {
    std::vector<LineHunk> hunks;
    auto x = static_cast<Index>(before_end_ - begin_);
    auto y = static_cast<Index>(after_end_ - begin_);
    for (auto d = static_cast<Index>(furthest_.size()) - 1; d > 0; --d) {
      const Index k = x - y;
      const Index down = At(d - 1, k + 1);
      const Index right = At(d - 1, k - 1);
      const bool is_down = right < 0 || down >= right + 1;
      const Index from_x = is_down ? down : right;
      const Index from_y = is_down ? from_x - (k + 1) : from_x - (k - 1);
      const Index to_x = is_down ? from_x : from_x + 1;
      const Index to_y = is_down ? from_y + 1 : from_y;
      Add(from_x, to_x, from_y, to_y, hunks);
      x = from_x;
      y = from_y;
    }
    std::reverse(hunks.begin(), hunks.end());
    return hunks;
  }

  void Add(Index x, Index to_x, Index y, Index to_y, std::vector<LineHunk>& hunks) const {
    const auto line = [this](Index at) { return begin_ + static_cast<std::size_t>(at); };
    if (!hunks.empty() && hunks.back().before_begin == line(to_x) &&
        hunks.back().after_begin == line(to_y)) {
      hunks.back().before_begin = line(x);
      hunks.back().after_begin = line(y);
    } else {
      hunks.push_back({line(x), line(to_x), line(y), line(to_y)});
    }
  }

  const Lines& before_;
  const Lines& after_;
  std::size_t begin_ = 0, before_end_ = 0, after_end_ = 0;
  std::vector<std::vector<Index>> furthest_;
};

}  // namespace

std::vector<LineHunk> CompareLines(std::string_view before, std::string_view after) {
  if (before == after) return {};
  const std::size_t old_count = CountLines(before);
  const std::size_t new_count = CountLines(after);
  if (old_count + new_count > kMostLines) return {{0, old_count, 0, new_count}};
  const Lines old_lines = SplitLines(before);
  const Lines new_lines = SplitLines(after);
  return Comparer(old_lines, new_lines).Run();
}

std::vector<LineMark> MarkLines(std::string_view before, std::string_view after) {
  const std::size_t lines = CountLines(after);
  std::vector<LineMark> marks(lines, LineMark::kSame);
  for (const LineHunk& hunk : CompareLines(before, after)) {
    if (hunk.after_begin == hunk.after_end) {
      LineMark& next = marks[std::min(hunk.after_begin, lines - 1)];
      if (next == LineMark::kSame) next = LineMark::kRemoved;
      continue;
    }
    const bool is_new = hunk.before_begin == hunk.before_end;
    std::fill(marks.begin() + static_cast<std::ptrdiff_t>(hunk.after_begin),
              marks.begin() + static_cast<std::ptrdiff_t>(hunk.after_end),
              is_new ? LineMark::kAdded : LineMark::kChanged);
  }
  return marks;
}

std::string_view LinesOf(std::string_view text, std::size_t begin, std::size_t end) {
  const Lines lines = SplitLines(text);
  if (begin >= end || end > lines.size()) return {};
  const char* const first = lines[begin].data();
  const std::string_view last = lines[end - 1];
  return {first, static_cast<std::size_t>(last.data() + last.size() - first)};
}

}  // namespace coppice::editor
