#include "editor/live/log_points.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace coppice::editor {
namespace {

constexpr char kIf[] = " if ";

std::string Trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

// "#3" at the end.
bool TakeHit(std::string& text, std::uint32_t& from_hit) {
  const std::size_t sign = text.rfind('#');
  if (sign == std::string::npos || (sign > 0 && text[sign - 1] != ' ')) return true;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data() + sign + 1, end, from_hit);
  if (error != std::errc() || at != end || from_hit == 0) return false;
  text.erase(sign);
  return true;
}

}  // namespace

std::string ToString(const LogPoint& point) {
  std::string text = point.text;
  if (!point.condition.empty()) text += kIf + point.condition;
  if (point.from_hit > 1) text += " #" + std::to_string(point.from_hit);
  return text;
}

Outcome ReadLogPoint(const std::string& typed, LogPoint& point) {
  std::string rest = Trimmed(typed);
  point.from_hit = 1;
  if (!TakeHit(rest, point.from_hit)) return Problem{"expected a number after #"};
  rest = " " + Trimmed(rest) + " ";
  const std::size_t at = rest.rfind(kIf);
  point.text = Trimmed(rest.substr(0, at));
  point.condition = at == std::string::npos ? "" : Trimmed(rest.substr(at + sizeof(kIf) - 1));
  if (at == std::string::npos || !point.condition.empty()) return {};
  return Problem{"expected a condition after if"};
}

const LogPoint* LogPoints::FindAt(const std::string& run, const std::string& path) const {
  const auto at = std::find_if(all_.begin(), all_.end(), [&](const LogPoint& point) {
    return (point.run.empty() || point.run == run) && point.path == path;
  });
  return at == all_.end() ? nullptr : &*at;
}

void LogPoints::Add(LogPoint point) {
  ++version_;
  point.number = ++last_number_;
  all_.push_back(std::move(point));
}

void LogPoints::Remove(std::uint32_t number) {
  ++version_;
  all_.erase(std::remove_if(all_.begin(), all_.end(),
                            [number](const LogPoint& point) { return point.number == number; }),
             all_.end());
}

void LogPoints::Change(std::uint32_t number, LogPoint point) {
  ++version_;
  for (LogPoint& known : all_) {
    if (known.number != number) continue;
    point.number = ++last_number_;
    known = std::move(point);
    return;
  }
}

}  // namespace coppice::editor
