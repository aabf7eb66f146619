#include "editor/timeline/bookmarks.h"

#include <iterator>

namespace coppice::editor {

const Bookmarks::OfRun& Bookmarks::Of(const std::string& run) const {
  static const OfRun kNone;
  const auto found = runs_.find(run);
  return found == runs_.end() ? kNone : found->second;
}

void Bookmarks::Remove(const std::string& run, std::size_t tick) {
  const auto found = runs_.find(run);
  if (found == runs_.end()) return;
  found->second.erase(tick);
  if (found->second.empty()) runs_.erase(found);
}

const Bookmarks::OfRun::value_type* Bookmarks::Next(const std::string& run,
                                                    std::size_t tick) const {
  const OfRun& all = Of(run);
  const auto next = all.upper_bound(tick);
  return next == all.end() ? nullptr : &*next;
}

const Bookmarks::OfRun::value_type* Bookmarks::Before(const std::string& run,
                                                      std::size_t tick) const {
  const OfRun& all = Of(run);
  const auto next = all.lower_bound(tick);
  return next == all.begin() ? nullptr : &*std::prev(next);
}

}  // namespace coppice::editor
