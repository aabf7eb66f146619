#include "bt_nodes/monitoring/health.h"

#include <algorithm>
#include <array>

namespace coppice::leaves {
namespace {

// Takes the text up to a separator off the front.
std::string_view TakeUntil(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

bool ParseLevel(std::string_view text, HealthLevel& level) {
  for (const HealthLevel known :
       {HealthLevel::kOk, HealthLevel::kWarn, HealthLevel::kError, HealthLevel::kStale}) {
    if (text != ToString(known)) continue;
    level = known;
    return true;
  }
  return false;
}

// Separators of the text form must not stand inside a field.
std::string Clean(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
  return text;
}

}  // namespace

const char* ToString(HealthLevel level) {
  constexpr std::array<const char*, 4> kNames = {"OK", "WARN", "ERROR", "STALE"};
  return kNames[static_cast<std::size_t>(level)];
}

HealthLevel LevelOfNumber(int number) {
  const bool is_known = number >= 0 && number <= static_cast<int>(HealthLevel::kStale);
  return is_known ? static_cast<HealthLevel>(number) : HealthLevel::kStale;
}

const HealthEntry* Health::FirstError(std::string_view monitor) const {
  const auto found = std::find_if(entries.begin(), entries.end(), [&](const HealthEntry& entry) {
    return entry.level >= HealthLevel::kError && entry.monitor == monitor;
  });
  return found == entries.end() ? nullptr : &*found;
}

bool ListsKind(std::string_view kinds, std::string_view monitor) {
  while (!kinds.empty()) {
    if (TakeUntil(kinds, ';') == monitor) return true;
  }
  return false;
}

bool Health::HasError(std::string_view kinds) const {
  return std::any_of(entries.begin(), entries.end(), [&](const HealthEntry& entry) {
    return entry.level >= HealthLevel::kError && ListsKind(kinds, entry.monitor);
  });
}

}  // namespace coppice::leaves

namespace coppice {

bool ValueTraits<leaves::Health>::Parse(std::string_view text, leaves::Health& out) {
  std::int64_t stamp = 0;
  if (!ValueTraits<std::int64_t>::Parse(leaves::TakeUntil(text, '\n'), stamp)) return false;
  out.stamp = TimeFromNanoseconds(stamp);
  out.entries.clear();
  while (!text.empty()) {
    std::string_view line = leaves::TakeUntil(text, '\n');
    leaves::HealthEntry entry;
    if (!leaves::ParseLevel(leaves::TakeUntil(line, '\t'), entry.level)) return false;
    entry.monitor = leaves::TakeUntil(line, '\t');
    entry.subject = leaves::TakeUntil(line, '\t');
    entry.node = leaves::TakeUntil(line, '\t');
    entry.message = line;
    out.entries.push_back(entry);
  }
  return true;
}

std::string ValueTraits<leaves::Health>::Print(const leaves::Health& value) {
  std::string text = std::to_string(ToNanoseconds(value.stamp));
  for (const leaves::HealthEntry& entry : value.entries) {
    text += std::string("\n") + ToString(entry.level) + "\t" + leaves::Clean(entry.monitor) + "\t" +
            leaves::Clean(entry.subject) + "\t" + leaves::Clean(entry.node) + "\t" +
            leaves::Clean(entry.message);
  }
  return text;
}

}  // namespace coppice
