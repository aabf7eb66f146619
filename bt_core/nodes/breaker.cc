#include "bt_core/nodes/breaker.h"

#include <algorithm>

namespace coppice {

std::size_t FailureTimes::Add(Time now, Time oldest) {
  const auto first = std::lower_bound(times_.begin(), times_.end(), ToNanoseconds(oldest));
  times_.erase(times_.begin(), first);
  times_.push_back(ToNanoseconds(now));
  return times_.size();
}

bool ValueTraits<FailureTimes>::Parse(std::string_view text, FailureTimes& out) {
  out.Clear();
  while (!text.empty()) {
    const std::size_t semicolon = std::min(text.find(';'), text.size());
    std::int64_t time = 0;
    if (!ValueTraits<std::int64_t>::Parse(text.substr(0, semicolon), time)) return false;
    if (!out.times_.empty() && time < out.times_.back()) return false;
    out.times_.push_back(time);
    text.remove_prefix(std::min(semicolon + 1, text.size()));
  }
  return true;
}

std::string ValueTraits<FailureTimes>::Print(const FailureTimes& value) {
  std::string text;
  for (const std::int64_t time : value.times_) {
    text += (text.empty() ? "" : ";") + std::to_string(time);
  }
  return text;
}

}  // namespace coppice
