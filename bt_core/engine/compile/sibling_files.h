// Where a tree that is missing may be: for advice in messages.
#ifndef COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_
#define COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_

#include <string>
#include <string_view>

namespace coppice {

/// The name of an XML file in the folder of `file` that defines that tree, or empty if none does or
/// if `file` itself is no file. Reads at most 1000 files, none of more than 4 MiB.
std::string FindTreeInFolder(const std::string& file, std::string_view tree_id);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_COMPILE_SIBLING_FILES_H_
