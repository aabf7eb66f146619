#include "editor/timeline/lane.h"

#include <algorithm>

namespace coppice::editor {

void Lane::Set(std::size_t tick, Status status) {
  bool is_restart = false;
  if (!entries_.empty() && TickOf(entries_.back()) == tick) {
    const std::uint32_t said = entries_.back();
    entries_.pop_back();
    is_restart = !entries_.empty() && StatusOf(entries_.back()) == StatusOf(said);
  }
  const Status before = entries_.empty() ? Status::kIdle : StatusOf(entries_.back());
  if (before != status || is_restart) Put(tick, status);
}

void Lane::Restart(std::size_t tick) {
  if (!entries_.empty() && TickOf(entries_.back()) < tick) Put(tick, StatusOf(entries_.back()));
}

void Lane::Put(std::size_t tick, Status status) {
  Summarise();
  entries_.push_back(static_cast<std::uint32_t>(tick << 3) | static_cast<std::uint32_t>(status));
}

// Called before an entry is added: what lies before it no longer changes.
void Lane::Summarise() {
  std::size_t size = kFan;
  for (std::size_t k = 0; entries_.size() >= size; ++k, size *= kFan) {
    if (levels_.size() == k) levels_.emplace_back();
    std::vector<StatusSet>& level = levels_[k];
    while ((level.size() + 1) * size <= entries_.size()) {
      StatusSet seen = 0;
      if (k == 0) {
        const auto first = entries_.begin() + static_cast<std::ptrdiff_t>(level.size() * kFan);
        std::for_each(first, first + kFan,
                      [&seen](std::uint32_t entry) { seen |= SetOf(StatusOf(entry)); });
      } else {
        const auto first =
            levels_[k - 1].begin() + static_cast<std::ptrdiff_t>(level.size() * kFan);
        std::for_each(first, first + kFan, [&seen](StatusSet part) { seen |= part; });
      }
      level.push_back(seen);
    }
  }
}

std::size_t Lane::FirstBehind(std::size_t tick) const {
  const auto behind =
      std::upper_bound(entries_.begin(), entries_.end(), tick,
                       [](std::size_t t, std::uint32_t entry) { return t < TickOf(entry); });
  return static_cast<std::size_t>(behind - entries_.begin());
}

Status Lane::At(std::size_t tick) const {
  const std::size_t behind = FirstBehind(tick);
  return behind == 0 ? Status::kIdle : StatusOf(entries_[behind - 1]);
}

std::size_t Lane::Since(std::size_t tick) const {
  const std::size_t behind = FirstBehind(tick);
  return behind == 0 ? 0 : TickOf(entries_[behind - 1]);
}

std::size_t Lane::NextChange(std::size_t tick) const {
  const std::size_t behind = FirstBehind(tick);
  return behind == entries_.size() ? tick : TickOf(entries_[behind]);
}

std::size_t Lane::ChangeBefore(std::size_t tick) const {
  const std::size_t behind = tick == 0 ? 0 : FirstBehind(tick - 1);
  return behind == 0 ? tick : TickOf(entries_[behind - 1]);
}

StatusSet Lane::Seen(std::size_t first, std::size_t end) const {
  if (first >= end) return 0;
  const std::size_t begin = FirstBehind(first);
  const StatusSet at_first = SetOf(begin == 0 ? Status::kIdle : StatusOf(entries_[begin - 1]));
  if (begin == entries_.size() || TickOf(entries_[begin]) >= end) return at_first;
  return static_cast<StatusSet>(at_first | SeenAmong(begin, FirstBehind(end - 1)));
}

// Takes the largest finished block that begins at `first` and fits, then goes on behind it.
StatusSet Lane::SeenAmong(std::size_t first, std::size_t end) const {
  StatusSet seen = 0;
  while (first < end) {
    std::size_t size = 1;
    std::size_t level = 0;  // one above that of the block; 0: a single entry
    while (level < levels_.size() && first % (size * kFan) == 0 && first + size * kFan <= end &&
           first / (size * kFan) < levels_[level].size()) {
      size *= kFan;
      ++level;
    }
    seen |= level == 0 ? SetOf(StatusOf(entries_[first])) : levels_[level - 1][first / size];
    first += size;
  }
  return seen;
}

}  // namespace coppice::editor
