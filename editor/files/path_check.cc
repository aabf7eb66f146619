#include "editor/files/path_check.h"

#include <filesystem>
#include <system_error>

namespace coppice::editor {

bool PathCheck::IsThere(const std::string& path, double now) {
  constexpr double kHolds = 1;  // seconds
  const auto at = seen_.find(path);
  if (at != seen_.end() && now - at->second.at < kHolds) return at->second.is_there;
  std::error_code error;
  const bool is_there = std::filesystem::exists(path, error);
  seen_[path] = {is_there, now};
  return is_there;
}

}  // namespace coppice::editor
