// A file and everything that it includes, as one set of trees by ID.
//
// <include path="..."/> is relative to the file that includes. A file is read once, however often
// it is included, so files may include each other. <include ros_pkg="..." path="..."/> asks the
// PackageFinder, so that the engine needs no ROS.
#ifndef COPPICE_BT_CORE_MODEL_PROJECT_H_
#define COPPICE_BT_CORE_MODEL_PROJECT_H_

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/model/document.h"

namespace coppice {

/// Where a <BehaviorTree> is defined: document number and element.
struct TreeDefinition {
  std::uint32_t document = 0;
  ElementIndex element = 0;
};

/// The folder of a ROS package, or empty if there is none.
using PackageFinder = std::function<std::string(const std::string& package)>;

class Project {
 public:
  /// Reads a file and its includes. Problems go to `diagnostics`; nothing is returned if one is an
  /// error.
  static std::optional<Project> FromFile(const std::string& path, Diagnostics& diagnostics,
                                         const PackageFinder& find_package = {});

  /// The same from a text; includes are relative to the folder of `file`.
  static std::optional<Project> FromText(std::string text, const std::string& file,
                                         Diagnostics& diagnostics,
                                         const PackageFinder& find_package = {});

  const std::vector<Document>& documents() const { return documents_; }
  const std::map<std::string, TreeDefinition, std::less<>>& trees() const { return trees_; }

  /// The tree of that ID, or null.
  const TreeDefinition* Find(std::string_view id) const;

  /// main_tree_to_execute of the first file; without it the only tree of that file; else empty.
  const std::string& main_tree() const { return main_tree_; }

 private:
  void Add(Document document, Diagnostics& diagnostics, const PackageFinder& find_package);
  void AddTree(std::uint32_t document, ElementIndex element, Diagnostics& diagnostics);
  void Include(std::uint32_t document, ElementIndex element, Diagnostics& diagnostics,
               const PackageFinder& find_package);
  void ChooseMainTree();

  std::vector<Document> documents_;
  std::map<std::string, TreeDefinition, std::less<>> trees_;
  std::string main_tree_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_PROJECT_H_
