// Elements named from outside: on a command line or in a bookmark.
//
//   Main/Sequence/Timeout[2]      the second Timeout in the Sequence at the root of tree Main
//   Main/dock the robot/Retry     a step is the name of a node, the ID of its type, or its tag
#ifndef COPPICE_BT_CORE_MODEL_ELEMENT_PATH_H_
#define COPPICE_BT_CORE_MODEL_ELEMENT_PATH_H_

#include <string_view>

#include "bt_core/model/document.h"

namespace coppice {

/// The element of that path: the ID of a <BehaviorTree>, then one step for each level. Among
/// siblings that fit a step, [n] takes the n-th, counted from 1; without it the first. An empty
/// path is the root element. kNoElement if there is none; then `diagnostics` names the step that
/// fits nothing.
ElementIndex FindByPath(const Document& document, std::string_view path, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_ELEMENT_PATH_H_
