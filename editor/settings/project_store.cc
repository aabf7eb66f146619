#include "editor/settings/project_store.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <vector>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr char kExtension[] = ".json";

// FNV-1a: the same in every version of the editor.
std::uint64_t HashOf(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

void ForgetOldest(const std::string& folder, std::size_t most) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() != kExtension) continue;
    files.emplace_back(fs::last_write_time(at->path(), ignored), at->path());
  }
  std::sort(files.rbegin(), files.rend());
  for (std::size_t i = most; i < files.size(); ++i) fs::remove(files[i].second, error);
}

}  // namespace

std::string ProjectStore::FileOf(const std::string& project) const {
  return folder_ + "/" + std::to_string(HashOf(project)) + kExtension;
}

std::optional<ProjectSettings> ProjectStore::Load(const std::string& project,
                                                  Diagnostics& diagnostics) const {
  const std::string file = FileOf(project);
  std::error_code error;
  if (folder_.empty() || !fs::exists(file, error)) return std::nullopt;
  Diagnostics problems;
  const std::optional<std::string> text = ReadFile(file, problems, kLongest);
  std::optional<ProjectSettings> settings;
  if (text) settings = ReadProject(*text, file, problems);
  diagnostics.Append(problems);
  // Half of what a damaged file says would be worse than none of it.
  if (problems.has_errors() || !settings || settings->folder != project) return std::nullopt;
  fs::last_write_time(file, fs::file_time_type::clock::now(), error);  // it is used
  return settings;
}

bool ProjectStore::Keep(const ProjectSettings& settings) const {
  if (folder_.empty()) return false;
  std::error_code error;
  fs::create_directories(folder_, error);
  Diagnostics ignored;
  if (!WriteFile(FileOf(settings.folder), WriteProject(settings), ignored)) return false;
  ForgetOldest(folder_, kMostProjects);
  return true;
}

}  // namespace coppice::editor
