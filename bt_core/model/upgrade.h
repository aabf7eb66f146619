// Trees of format 3 (BehaviorTree.CPP 3) as trees of format 4: an Edit, so that comments and layout
// stay. What means the same in both formats is not touched.
//
//   SubTreePlus __autoremap        SubTree _autoremap
//   SubTree port="key"             SubTree port="{key}"    (in format 3 it is the name of a key)
//   __shared_blackboard="true"     _autoremap="true"
//   SequenceStar                   SequenceWithMemory
//   FallbackStar                   Fallback                (which has had a memory since format 3)
//   RetryUntilSuccesful            RetryUntilSuccessful
//   Parallel success_threshold     Parallel success_count  (and failure_, and threshold)
//   BlackboardCheckInt and others  ReactiveSequence of a ScriptCondition and the child
//   <Root> around a tree           nothing
//   <Recharge/>, a tree's ID       <SubTree ID="Recharge"/>
//   output="key"                   output="{key}"          (if the file has a model that says so)
//   __shared_blackboard in models  nothing                 (Groot 1 lists it as a port)
//
// Sources: convert_v3_to_v4.py and the migration guides of BehaviorTree.CPP. Its converter lets the
// last seven rows be.
#ifndef COPPICE_BT_CORE_MODEL_UPGRADE_H_
#define COPPICE_BT_CORE_MODEL_UPGRADE_H_

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "bt_core/model/document.h"

namespace coppice {

/// True if the root element says BTCPP_format="3"; or if it says nothing, unless the file uses what
/// only format 4 has (guards, scripts, _autoremap, keys in braces on a SubTree) and nothing that
/// only format 3 has.
bool IsFormat3(const Document& document);

/// What a node type, or a port of one, of format 3 is called now; empty if nothing has changed.
std::string_view NodeNameInFormat4(std::string_view old);
std::string_view PortNameInFormat4(std::string_view type, std::string_view old);

using TreeNames = std::set<std::string, std::less<>>;

/// What makes the document format 4. What cannot be upgraded stays and is a warning with its place.
/// Empty if it is not of format 3. `trees`: the IDs of trees in other files, which it may use as
/// node types, too.
Edit UpgradeToFormat4(const Document& document, Diagnostics& diagnostics,
                      const TreeNames& trees = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_UPGRADE_H_
