// What belongs to a project and is found again when one of its files is opened: the files that were
// open, tabs and closed nodes of their trees, the layout of trees, which tiles are shown. A project
// is a working tree of git, or else a folder of trees.
//
//   const std::string folder = ProjectFolder("/home/me/robot/patrol.xml");  // "/home/me/robot"
//   ProjectSettings settings = ReadProject(text, file, diagnostics);
//   WriteFile(file, WriteProject(settings), diagnostics);
#ifndef COPPICE_EDITOR_SETTINGS_PROJECT_SETTINGS_H_
#define COPPICE_EDITOR_SETTINGS_PROJECT_SETTINGS_H_

#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

struct ProjectTree {
  std::string file;  ///< below the folder of the project
  std::string tree;  ///< ID
  bool has_tab = false;
  std::vector<std::string> closed;  ///< as TreeView::ClosedNodes
};

struct ProjectSettings {
  std::string folder;  ///< of the project, absolute
  LayoutStyle style;
  Tiles tiles;
  std::vector<std::string> files;  ///< that were open, below the folder
  std::vector<ProjectTree> trees;  ///< with a tab, in their order; then those with closed nodes
};

/// The path of a file as one below that folder; empty: it is not.
std::string PathInProject(const std::string& folder, const std::string& file);

/// From JSON. What cannot be right is said and left out: a path that leads out of the project, say.
ProjectSettings ReadProject(const std::string& text, const std::string& file,
                            Diagnostics& diagnostics);
std::string WriteProject(const ProjectSettings& settings);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SETTINGS_PROJECT_SETTINGS_H_
