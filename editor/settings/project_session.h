// Gives every project its settings back, and keeps them: that of the shown file has the screen.
//
//   ProjectSession session(folder);
//   session.Follow(state);            // after a file was opened, and once per frame
//   session.OpenRest(state);          // later: the first frame waits for one file
//   session.Keep(state);              // now and then, and at the end
#ifndef COPPICE_EDITOR_SETTINGS_PROJECT_SESSION_H_
#define COPPICE_EDITOR_SETTINGS_PROJECT_SESSION_H_

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "editor/settings/project_store.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

class ProjectSession {
 public:
  /// Where settings are kept; empty: nowhere, and nothing is switched.
  explicit ProjectSession(std::string folder)
      : is_on_(!folder.empty()), store_(std::move(folder)) {}

  /// If the shown file belongs to another project than before, gives that one the screen. A project
  /// that was never seen takes over what is there. Runs and files without a place on the disk leave
  /// the project as it is.
  void Follow(EditorState& state);

  /// Opens the files of the project that were open the last time and are still there, and their
  /// tabs; what is shown stays. False if there was nothing to open.
  bool OpenRest(EditorState& state);

  void Keep(const EditorState& state);

 private:
  ProjectSettings SettingsOf(const EditorState& state) const;
  void Begin(EditorState& state, const ProjectSettings& settings);

  bool is_on_;
  ProjectStore store_;
  std::string path_;                             // of the file that was shown last
  std::string project_;                          // its folder; empty: none yet
  std::map<std::string, ProjectSettings> seen_;  // in this session, as they were left
  std::string kept_;                             // of project_, as it is on the disk
  ProjectSettings rest_;                         // that is still to be opened
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SETTINGS_PROJECT_SESSION_H_
