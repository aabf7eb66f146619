#include "editor/commands/command_needs.h"

#include <stdexcept>
#include <string>
#include <string_view>

#include "editor/commands/difference_commands.h"
#include "editor/commands/run_commands.h"
#include "editor/workspace/simulation_editor.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

// Why it is not there; empty: it is.
using Need = std::string (*)(EditorState&);

const SceneNode* SelectedNode(EditorState& state) {
  const TreeView* view = state.workspace.view();
  if (!view || view->selected() == kNoSceneNode) return nullptr;
  return &view->scene()->nodes[view->selected()];
}

std::string NeedsFile(EditorState& state) {
  return state.workspace.file() ? "" : "no file is open";
}
std::string NeedsTree(EditorState& state) {
  return state.workspace.view() ? "" : "no tree is shown";
}
std::string NeedsNode(EditorState& state) {
  return SelectedNode(state) ? "" : "no node is selected";
}
std::string NeedsEditable(EditorState& state) {
  return TreeEditor(state, state.now).CanEdit().problem();
}
std::string NeedsEditedNode(EditorState& state) {
  const std::string why = NeedsEditable(state);
  return why.empty() ? NeedsNode(state) : why;
}
std::string NeedsSubTree(EditorState& state) {
  const SceneNode* const node = SelectedNode(state);
  if (!node) return "no node is selected";
  return node->shape == Shape::kSubTree ? "" : "the node is not a SubTree";
}
std::string NeedsEditedSubTree(EditorState& state) {
  const std::string why = NeedsEditable(state);
  return why.empty() ? NeedsSubTree(state) : why;
}
std::string NeedsChildren(EditorState& state) {
  if (!SelectedNode(state)) return "no node is selected";
  const TreeView& view = *state.workspace.view();
  return view.scene()->HasChildren(view.selected()) ? "" : "the node has no children";
}
std::string NeedsClipboard(EditorState& state) {
  const std::string why = NeedsEditable(state);
  if (!why.empty()) return why;
  return state.services.get_clipboard().empty() ? "nothing was copied" : "";
}
std::string NeedsStep(EditorState& state) {
  const History& history = state.workspace.project().history();
  return history.done() > 0 ? "" : "nothing has been done yet";
}
std::string NeedsUndoneStep(EditorState& state) {
  const History& history = state.workspace.project().history();
  return history.done() < history.steps().size() ? "" : "nothing has been undone";
}
std::string NeedsTabs(EditorState& state) {
  return state.canvas.tabs.size() > 1 ? "" : "it is the only tab";
}
std::string NeedsRun(EditorState& state) {
  return state.workspace.run() ? "" : "no robot, record or simulation is shown";
}
std::string NeedsNodeOfRun(EditorState& state) {
  const std::string why = NeedsRun(state);
  return why.empty() ? NeedsNode(state) : why;
}
std::string NeedsRobot(EditorState& state) {
  const RunView* run = state.workspace.run();
  return run && run->source().is_robot() ? "" : "no robot is shown";
}
std::string NeedsPictures(EditorState& state) {
  const std::string why = NeedsRun(state);
  if (!why.empty()) return why;
  return state.workspace.run()->pictures().empty() ? "the robot shows nothing to people" : "";
}
std::string NeedsSimulation(EditorState& state) {
  const bool is_shown = SimulationEditor(state, state.now).IsShown();
  return is_shown ? "" : "no simulation is shown: F5 begins one";
}
std::string NeedsSimulatedLeaf(EditorState& state) {
  const std::string why = NeedsSimulation(state);
  if (!why.empty()) return why;
  return SimulationEditor(state, state.now).SelectedLeaf() == kNoNode ? "no leaf is selected" : "";
}
std::string NeedsKey(EditorState& state) {
  const std::string why = NeedsRun(state);
  if (!why.empty()) return why;
  return state.blackboard.shown_key.empty() ? "no key of the blackboard is chosen" : "";
}
std::string NeedsComparison(EditorState& state) {
  return state.canvas.comparison ? "" : "nothing is compared";
}
std::string NeedsDifferences(EditorState& state) {
  return ShownRunComparison(state) ? "" : NeedsComparison(state);
}
std::string NeedsUnsaved(EditorState& state) {
  return state.work.left().empty() ? "no earlier session left unsaved work" : "";
}
std::string NeedsRecent(EditorState& state) {
  return state.recent.files.empty() ? "nothing has been opened yet" : "";
}
std::string NeedsRobots(EditorState& state) {
  return state.OfferedRobots().empty() ? "no robot has been met, and the network tells of none"
                                       : "";
}
std::string NeedsKnownRobots(EditorState& state) {
  return state.recent.robots.empty() ? "no robot has been met yet" : "";
}

struct CommandNeed {
  std::string_view command;
  Need need;
};
constexpr CommandNeed kNeeds[] = {{"file.recent", NeedsRecent},
                                  {"robot.known", NeedsRobots},
                                  {"robot.forget", NeedsKnownRobots},
                                  {"file.unsaved", NeedsUnsaved},
                                  {"file.reload", NeedsFile},
                                  {"file.save", NeedsFile},
                                  {"file.save_as", NeedsFile},
                                  {"file.include", NeedsEditable},
                                  {"file.export", NeedsTree},
                                  {"file.compare", NeedsTree},
                                  {"file.stop_comparing", NeedsComparison},
                                  {"difference.next", NeedsDifferences},
                                  {"difference.previous", NeedsDifferences},
                                  {"edit.undo", NeedsStep},
                                  {"edit.redo", NeedsUndoneStep},
                                  {"edit.add", NeedsEditable},
                                  {"edit.add_after", NeedsEditedNode},
                                  {"edit.add_around", NeedsEditedNode},
                                  {"edit.rename", NeedsEditedNode},
                                  {"edit.change_type", NeedsEditedNode},
                                  {"edit.first_port", NeedsNode},
                                  {"edit.ports_here", NeedsEditedNode},
                                  {"edit.add_port", NeedsEditedNode},
                                  {"edit.cut", NeedsEditedNode},
                                  {"edit.copy", NeedsNode},
                                  {"edit.paste", NeedsClipboard},
                                  {"edit.paste_after", NeedsClipboard},
                                  {"edit.duplicate", NeedsEditedNode},
                                  {"edit.disable", NeedsEditedNode},
                                  {"edit.delete", NeedsEditedNode},
                                  {"edit.delete_only", NeedsEditedNode},
                                  {"edit.select_all", NeedsTree},
                                  {"edit.replace", NeedsEditable},
                                  {"edit.xml", NeedsFile},
                                  {"type.define", NeedsEditable},
                                  {"key.rename", NeedsEditedNode},
                                  {"key.copy", NeedsKey},
                                  {"key.copy_value", NeedsKey},
                                  {"blackboard.write", NeedsKey},
                                  {"tree.extract", NeedsEditedNode},
                                  {"tree.inline", NeedsEditedSubTree},
                                  {"tree.definition", NeedsSubTree},
                                  {"tree.new", NeedsEditable},
                                  {"tree.rename", NeedsEditable},
                                  {"tree.delete", NeedsEditable},
                                  {"tree.collapse", NeedsChildren},
                                  {"tree.collapse_others", NeedsNode},
                                  {"tree.open_subtrees", NeedsTree},
                                  {"tree.close_subtrees", NeedsTree},
                                  {"view.fit_all", NeedsTree},
                                  {"view.fit_selection", NeedsNode},
                                  {"view.zoom_100", NeedsTree},
                                  {"tab.next", NeedsTabs},
                                  {"tab.previous", NeedsTabs},
                                  {"tab.close", NeedsTabs},
                                  {"tab.close_others", NeedsTabs},
                                  {"run.why", NeedsNodeOfRun},
                                  {"run.change_before", NeedsNodeOfRun},
                                  {"run.next_change", NeedsNodeOfRun},
                                  {"run.pin", NeedsNodeOfRun},
                                  {"run.to_here", NeedsNodeOfRun},
                                  {"run.breakpoint", NeedsNode},
                                  {"run.breakpoint_enable", NeedsNode},
                                  {"run.breakpoint_condition", NeedsNode},
                                  {"run.log_point", NeedsNode},
                                  {"run.force_success", NeedsNode},
                                  {"run.force_failure", NeedsNode},
                                  {"run.force_running", NeedsNode},
                                  {"run.force_skipped", NeedsNode},
                                  {"run.delay", NeedsNode},
                                  {"run.pictures", NeedsPictures},
                                  {"run.pause", NeedsRobot},
                                  {"run.continue", NeedsRobot},
                                  {"run.step_tick", NeedsRobot},
                                  {"run.step_node", NeedsRobot},
                                  {"sim.start", NeedsTree},
                                  {"sim.success", NeedsSimulatedLeaf},
                                  {"sim.failure", NeedsSimulatedLeaf},
                                  {"sim.running", NeedsSimulatedLeaf},
                                  {"sim.skipped", NeedsSimulatedLeaf},
                                  {"sim.script", NeedsSimulatedLeaf}};

// Of those without a row: by what is shown.
Need NeedOf(const EditorCommand& command) {
  for (const CommandNeed& row : kNeeds) {
    if (row.command == command.id) return row.need;
  }
  if (!command.when) return nullptr;
  return command.id.rfind("sim.", 0) == 0 ? NeedsSimulation : NeedsRun;
}

}  // namespace

void AddNeeds(EditorState& state) {
  for (const CommandNeed& row : kNeeds) {
    if (!state.commands.Find(row.command)) {
      throw std::logic_error("no such command: " + std::string(row.command));
    }
  }
  for (const EditorCommand& command : state.commands.all()) {
    const Need need = NeedOf(command);
    if (need) state.commands.SetWhyNot(command.id, [&state, need] { return need(state); });
  }
}

}  // namespace coppice::editor
