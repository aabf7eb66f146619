// Files and all that they include, as trees by ID (a sole one without ID is BehaviorTree_0).
//
//   Diagnostics diagnostics;
//   std::optional<Project> project = Project::FromFile("robot.xml", diagnostics);
//
// <include path="..."/> is relative to the file that includes. A file is read once, however often
// it is included, so files may include each other. <include ros_pkg="..." path="..."/> asks the
// PackageFinder.
//
// A problem does not hide others: what can be read is there, so that a compiler or an editor can go
// on. has_errors() tells that the Project is not whole; nothing compiles from such a one.
#ifndef COPPICE_BT_CORE_MODEL_PROJECT_H_
#define COPPICE_BT_CORE_MODEL_PROJECT_H_

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/model/document.h"
#include "bt_core/model/include_path.h"
#include "bt_core/model/node_model.h"

namespace coppice {

/// Where a <BehaviorTree> is defined: document number and element. It has at least one child.
struct TreeDefinition {
  std::uint32_t document = 0;
  ElementIndex element{0};
};

using NodeModelMap = std::map<std::string, NodeModel, std::less<>>;

/// Gives the document of a file, as Document::FromFile does.
using DocumentReader =
    std::function<std::optional<Document>(const std::string& path, Diagnostics& diagnostics)>;

class Project {
 public:
  /// Reads a file and its includes. Problems go to `diagnostics`; nothing is returned if the file
  /// itself cannot be read or is malformed. Without a finder, FindRosPackage is asked.
  static std::optional<Project> FromFile(const std::string& path, Diagnostics& diagnostics,
                                         const PackageFinder& find_package = {});

  /// Reads several files as one project: a SubTree may lie in any of them. The first file comes
  /// first in documents(). Nothing is returned if none of them can be read. With a reader, files
  /// that are being edited count as they are in memory.
  static std::optional<Project> FromFiles(const std::vector<std::string>& paths,
                                          Diagnostics& diagnostics,
                                          const PackageFinder& find_package = {},
                                          const DocumentReader& read = {});

  /// The same from a text; includes are relative to the folder of `file`.
  static std::optional<Project> FromText(std::string text, const std::string& file,
                                         Diagnostics& diagnostics,
                                         const PackageFinder& find_package = {});

  /// True if something of the project could not be read.
  bool has_errors() const { return has_errors_; }

  const std::vector<Document>& documents() const { return documents_; }

  /// The document was of format 3; it is kept as one of format 4.
  bool WasFormat3(std::uint32_t document) const { return was_format_3_[document]; }

  const std::map<std::string, TreeDefinition, std::less<>>& trees() const { return trees_; }

  /// The tree of that ID, or null.
  const TreeDefinition* Find(std::string_view id) const;

  /// The tree to run: main_tree_to_execute of the first given file that has it, without it the only
  /// tree of the first file, else empty.
  const std::string& main_tree() const { return main_tree_; }

  /// The types that the files describe in <TreeNodesModel>, by ID. Models of SubTrees are not among
  /// them: a tree and a leaf of the same name are different things.
  const NodeModelMap& models() const { return models_; }

  /// The trees that a file of format 3 may use as node types, by their IDs: of which no model says
  /// that they are those of nodes.
  std::set<std::string, std::less<>> TreesUsedByName() const;

  /// The models of SubTrees by the ID of their tree.
  const NodeModelMap& subtree_models() const { return subtree_models_; }

  /// The model of that tree's ports, or null if no file describes them.
  const NodeModel* SubTreeModel(std::string_view id) const;

 private:
  friend class ProjectReader;
  Project() = default;

  std::vector<Document> documents_;
  std::vector<bool> was_format_3_;  // by document
  std::map<std::string, TreeDefinition, std::less<>> trees_;
  NodeModelMap models_;
  NodeModelMap subtree_models_;
  std::string main_tree_;
  bool has_errors_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_PROJECT_H_
