#include "editor/keys/age_text.h"

namespace coppice::editor {

std::string AgeText(std::int64_t seconds) {
  const auto ago = [](std::int64_t number, const std::string& unit) {
    return std::to_string(number) + " " + unit + (number == 1 ? "" : "s") + " ago";
  };
  const std::int64_t minutes = seconds / 60;
  if (minutes < 1) return "a moment ago";
  if (minutes < 60) return ago(minutes, "minute");
  if (minutes < 24 * 60) return ago(minutes / 60, "hour");
  return ago(minutes / (24 * 60), "day");
}

}  // namespace coppice::editor
