// The tree of a run as a file again, to edit it or to run it elsewhere.
//
//   const std::string xml = TreeFile(*run.tree());
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_TREE_FILE_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_TREE_FILE_H_

#include <string>

#include "bt_core/frames/tree_description.h"

namespace coppice {

/// One file that runs the same tree. Of one file that is its text byte for byte, but for
/// main_tree_to_execute if it has several trees and does not name the one that ran; of several what
/// the others define stands at the end of the first, and the includes go. What robots of
/// BehaviorTree.CPP add goes: the attributes _uid and _fullpath, and a tree for each SubTree that
/// uses it.
std::string TreeFile(const TreeDescription& tree);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_TREE_FILE_H_
