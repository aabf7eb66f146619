// The settings of projects on the disk: a file for each in a folder of the user's, and never in the
// project itself. Those that were not used for longest are forgotten.
//
//   ProjectStore store("/home/me/.local/state/coppice/projects");
//   if (auto settings = store.Load("/home/me/robot", diagnostics)) ...
//   store.Keep(settings);
#ifndef COPPICE_EDITOR_SETTINGS_PROJECT_STORE_H_
#define COPPICE_EDITOR_SETTINGS_PROJECT_STORE_H_

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "editor/settings/project_settings.h"

namespace coppice::editor {

class ProjectStore {
 public:
  static constexpr std::size_t kMostProjects = 100;
  static constexpr std::size_t kLongest = std::size_t{1} << 20;  ///< of a file [bytes]

  /// An empty folder: nothing is kept.
  explicit ProjectStore(std::string folder) : folder_(std::move(folder)) {}

  /// Nothing if the project is not known, or if its file is damaged; then the reason is in
  /// `diagnostics`.
  std::optional<ProjectSettings> Load(const std::string& project, Diagnostics& diagnostics) const;

  /// False if it could not be written: the next time it may.
  bool Keep(const ProjectSettings& settings) const;

  /// The file of a project.
  std::string FileOf(const std::string& project) const;

 private:
  std::string folder_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SETTINGS_PROJECT_STORE_H_
