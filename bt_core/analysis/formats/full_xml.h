// A recorded tree as BehaviorTree.CPP's tools want it: one <BehaviorTree> for each instance, nodes
// with _uid (their number + 1), instances with _fullpath, and the models of all node types.
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_FULL_XML_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_FULL_XML_H_

#include <string>

#include "bt_core/frames/tree_description.h"

namespace coppice {

std::string FullXml(const TreeDescription& tree);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_FULL_XML_H_
