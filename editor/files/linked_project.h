// The trees that a file can use in the editor: its own, those of its includes, and those of the
// other open files of the same project, as if they were given to `coppice` together. Many robots
// read a folder of trees that include nothing.
//
//   const std::optional<LinkedProject> linked = ReadLinked(files, "patrol.xml", diagnostics);
#ifndef COPPICE_EDITOR_FILES_LINKED_PROJECT_H_
#define COPPICE_EDITOR_FILES_LINKED_PROJECT_H_

#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "bt_core/model/project.h"
#include "editor/files/open_project.h"

namespace coppice::editor {

struct LinkedProject {
  Project project;
  std::size_t own_documents = 0;  ///< the first ones of project: the file and its includes
  std::string main_tree;          ///< of the file; empty if there is none
};

/// The file is opened if it is not. Of the other files only those are in it that have trees which
/// are missing without them; not one whose trees would come twice then. What is wrong with them is
/// not said here. Nothing if the file cannot be read or is malformed.
std::optional<LinkedProject> ReadLinked(OpenProject& files, const std::string& path,
                                        Diagnostics& diagnostics);

/// The file and its includes alone, as they are in memory.
std::optional<Project> ReadOpenProject(OpenProject& files, const std::string& path,
                                       Diagnostics& diagnostics);

/// The IDs that SubTrees of these documents name and that no tree of them has.
std::set<std::string> MissingTrees(const Project& project);

/// The nearest folder above the file with a `.git`, or else the file's own; absolute. What lies in
/// it is one project.
std::string ProjectFolder(const std::string& file);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_LINKED_PROJECT_H_
