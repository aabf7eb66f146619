// The trees that can be shown together: those of a file with its includes and of what is linked
// with it, or those that a robot runs. Immutable; views into it live as long as it does.
#ifndef COPPICE_EDITOR_SCENE_FOREST_H_
#define COPPICE_EDITOR_SCENE_FOREST_H_

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/model/document.h"
#include "bt_core/model/project.h"

namespace coppice::editor {

/// One <BehaviorTree>. A robot sends one for every instance, with its path.
struct TreeEntry {
  std::string id;
  std::string instance_path;  ///< empty for a definition and for the main tree
  std::uint32_t document = 0;
  ElementIndex element{0};
};

class Forest {
 public:
  /// A file with its includes, from the disk. What is wrong goes to `diagnostics`; what can be read
  /// is shown. If the file itself is malformed, there are no trees.
  static Forest FromFile(const std::string& path, Diagnostics& diagnostics);

  /// Of a project the first documents are a file and its includes.
  static Forest FromProject(Project project, std::size_t own_documents, std::string_view main_tree);

  /// Texts that belong together, whatever they include, in this order: those that a robot runs.
  static Forest FromDocuments(std::vector<Document> documents, std::string_view main_tree);

  const std::vector<const Document*>& documents() const { return documents_; }
  /// So many of them, the first ones, are the file and its includes; all are those of a robot.
  std::size_t own_documents() const { return own_documents_; }
  const std::vector<TreeEntry>& trees() const { return trees_; }

  /// The tags that nodes of these files have, each once.
  const std::vector<std::string_view>& used_tags() const { return used_tags_; }

  /// The tree to show first: the main tree, else the first. -1 if there is none.
  int main_tree() const { return main_tree_; }

  /// Number of the tree of that ID, or -1.
  int Find(std::string_view id) const;

  /// Number of the tree that a <SubTree> element stands for, or -1.
  int Resolve(const Document& document, const Element& subtree) const;

  /// The project; null if the file cannot be read, or if the texts are those of a robot.
  const std::shared_ptr<const Project>& project() const { return project_; }

 private:
  void AddAll();
  void AddTreesOf(std::uint32_t document);
  void AddTagsOf(const Document& document);
  void ChooseMain(std::string_view id);

  std::shared_ptr<const Project> project_;
  std::shared_ptr<const std::vector<Document>> texts_;  // if there is no project
  std::vector<const Document*> documents_;
  std::size_t own_documents_ = 0;
  std::vector<TreeEntry> trees_;
  std::vector<std::string_view> used_tags_;
  int main_tree_ = -1;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_FOREST_H_
