#include "editor/core/canvas_drops.h"

#include <algorithm>

#include "editor/core/tree_editor.h"
#include "editor/document/drop_edits.h"
#include "editor/document/tree_edits.h"

namespace coppice::editor {
namespace {

// A drop in the words of the document.
struct DropPlan {
  std::string refusal;
  std::string name;  // of the step
  TreeEditor::Edit edit;
};

std::string Quoted(const SceneNode& node) { return std::string(node.name); }

DropPlan Plan(EditorState& state, double now, const DropRequest& request) {
  DropPlan plan;
  const TreeView& view = *state.workspace.view();
  const SceneNode& target = view.scene()->nodes[request.target.node];
  const auto place = state.workspace.PlaceOf(target);
  if (!place) {
    plan.refusal = "this cannot be changed here";
    return plan;
  }
  const TreeEditor editor(state, now);
  for (const Place& selected : editor.SelectedPlaces()) {
    if (selected.path != place->path) plan.refusal = "nodes of another file: cut and paste them";
  }
  const std::string what = editor.What();
  const ElementIndex element = place->element;
  const bool onto = request.target.place == DropPlace::kNode;
  if (request.target.place == DropPlace::kEdge) {
    if (request.copy) plan.refusal = "a copy goes beside a node or into it";
    plan.name = "Put " + what + " around " + Quoted(target);
    plan.edit = [element](Draft& draft, const NodeRules& rules) {
      return PutAround(draft, rules, element);
    };
  } else if (onto && request.replace) {
    plan.name = "Replace " + Quoted(target) + " by " + what;
    plan.edit = [element](Draft& draft, const NodeRules& rules) {
      return TakePlaceOf(draft, rules, element);
    };
  } else {
    const std::uint32_t position = onto ? UINT32_MAX : request.target.index;
    const bool copy = request.copy;
    plan.name = (copy ? "Copy " : "Move ") + what + " into " + Quoted(target);
    plan.edit = [element, position, copy](Draft& draft, const NodeRules& rules) {
      return copy ? CopyInto(draft, rules, element, position)
                  : MoveInto(draft, rules, element, position);
    };
  }
  return plan;
}

}  // namespace

std::string WhyNoDrop(EditorState& state, double now, const DropRequest& request) {
  DropCheck& last = state.canvas.drop_check;
  const std::uint64_t version = state.workspace.project().version();
  const std::vector<std::uint32_t>& nodes = state.workspace.view()->selection();
  const bool same = last.version == version && last.nodes == nodes &&
                    last.request.target == request.target && last.request.copy == request.copy &&
                    last.request.replace == request.replace;
  if (same) return last.why_not;
  const TreeEditor editor(state, now);
  std::string why_not = editor.WhyReadOnly();
  if (why_not.empty()) {
    const DropPlan plan = Plan(state, now, request);
    why_not = plan.refusal.empty() ? editor.WhyNot(plan.edit) : plan.refusal;
  }
  last = {request, nodes, version, why_not};
  return why_not;
}

void Drop(EditorState& state, double now, const DropRequest& request) {
  const DropPlan plan = Plan(state, now, request);
  if (!plan.refusal.empty()) {
    state.Notify(plan.refusal, now, true);
    return;
  }
  TreeEditor(state, now).Run(plan.name, plan.edit);
}

}  // namespace coppice::editor
