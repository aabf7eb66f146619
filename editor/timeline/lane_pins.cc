#include "editor/timeline/lane_pins.h"

#include <algorithm>

namespace coppice::editor {

const std::vector<std::string>& LanePins::Of(const std::string& run) const {
  static const std::vector<std::string> kNone;
  const auto at = runs_.find(run);
  return at == runs_.end() ? kNone : at->second;
}

bool LanePins::Has(const std::string& run, const std::string& path) const {
  const std::vector<std::string>& pins = Of(run);
  return std::find(pins.begin(), pins.end(), path) != pins.end();
}

void LanePins::Toggle(const std::string& run, const std::string& path) {
  std::vector<std::string>& pins = runs_[run];
  const auto at = std::find(pins.begin(), pins.end(), path);
  if (at == pins.end()) {
    pins.push_back(path);
  } else {
    pins.erase(at);
  }
  if (pins.empty()) runs_.erase(run);
}

}  // namespace coppice::editor
