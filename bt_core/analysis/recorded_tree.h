// A recorded tree as a program again: compiled from the documents and the models of node types that
// are in the record, without the program that ran it. Then ports, scripts and guards can be looked
// up, and the tree can be run once more (verify.h).
//
//   Diagnostics diagnostics;
//   const RecordedTree tree = CompileRecorded(description, std::make_shared<Registry>(),
//                                             diagnostics);
#ifndef COPPICE_BT_CORE_ANALYSIS_RECORDED_TREE_H_
#define COPPICE_BT_CORE_ANALYSIS_RECORDED_TREE_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/engine/program.h"
#include "bt_core/frames/tree_description.h"

namespace coppice {

struct RecordedTree {
  std::shared_ptr<const TreeDescription> description;
  TreeShape shape;
  /// Null if the documents could not be compiled to the described nodes. Its nodes have the
  /// described numbers, its slots have not.
  std::shared_ptr<const Program> program;
  std::shared_ptr<const Project> project;  ///< what it was compiled from
  std::vector<SlotIndex> program_slots;    ///< per described slot its number in the program
  std::vector<SlotIndex> recorded_slots;   ///< the reverse; kNoSlot in both: no counterpart

  const std::string& PathOf(NodeIndex node) const { return description->nodes[node].path; }
  /// The last part of the path.
  std::string NameOf(NodeIndex node) const;
  /// The node of that path, or of the only path that ends in it; kNoNode, with advice in
  /// `diagnostics`, if there is none or several.
  NodeIndex Find(const std::string& path, Diagnostics& diagnostics) const;
};

/// The registry brings the types of the application if they are at hand (plugins); what it does not
/// know is taken from the models in the description. Warnings say why there is no program.
RecordedTree CompileRecorded(const TreeDescription& description, std::shared_ptr<Registry> registry,
                             Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_RECORDED_TREE_H_
