// Nodes that do again what the nodes of the user did in a recorded run: the same results, writes
// and messages, the same children ticked and halted, at the same places of the walk.
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_NODES_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_NODES_H_

#include <memory>

#include "bt_core/analysis/play/prompter.h"
#include "bt_core/engine/program.h"

namespace coppice {

/// The program with played nodes in the place of all nodes of the user. The prompter must live
/// longer than the executors of it.
std::shared_ptr<const Program> WithPlayedNodes(const Program& program, Prompter& prompter);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_NODES_H_
