#include "bt_core/live/pictures/live_pictures.h"

#include <algorithm>
#include <utility>

namespace coppice {

Outcome LivePictures::Show(LivePicture picture) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto shown = pictures_.all().find(picture.name);
  if (shown != pictures_.all().end() && shown->second == picture) return {};
  const std::string name = picture.name;
  Outcome outcome = pictures_.Put(std::move(picture));
  if (!outcome) return outcome;
  const auto before = std::find_if(last_changes_.begin(), last_changes_.end(),
                                   [&](const auto& change) { return change.second == name; });
  if (before != last_changes_.end()) last_changes_.erase(before);
  last_changes_[++changes_] = name;
  return {};
}

std::optional<LivePicture> LivePictures::Next(std::uint64_t& seen) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto next = last_changes_.upper_bound(seen);
  if (next == last_changes_.end()) return std::nullopt;
  seen = next->first;
  return pictures_.all().at(next->second);
}

}  // namespace coppice
