// Where a tree that is missing may be: for advice in messages.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_

#include <map>
#include <string>
#include <string_view>

namespace coppice {

/// Reads a folder when something in it is missing for the first time, and then no more.
class SiblingFiles {
 public:
  /// The name of an XML file in the folder of `file` that defines that tree, or empty if none does
  /// or if `file` itself is no file. Looks into 1000 files and 16 MiB at most, none of more than
  /// 4 MiB; the first ones by name.
  std::string FindTree(const std::string& file, std::string_view tree_id);

 private:
  using FileOfTree = std::map<std::string, std::string, std::less<>>;
  std::map<std::string, FileOfTree> folders_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_
