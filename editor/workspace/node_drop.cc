#include "editor/workspace/node_drop.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "editor/document/drop_edits.h"
#include "editor/document/fragment.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

struct Spot {
  std::string path;
  DropSpot at;
};

// From the scene to the file.
class Translation {
 public:
  Translation(EditorState& state, const Drag& drag, const DropRequest& request)
      : state_(state), drag_(drag), request_(request), scene_(*state.workspace.view()->scene()) {}

  // A problem for what is in no file or where there is no room by nature.
  Expected<Spot> Where() const {
    const DropTarget& target = request_.target;
    const SceneNode& node = scene_.nodes[target.node];
    const auto place = state_.workspace.PlaceOf(node);
    if (!place) return Problem{"this cannot be changed"};
    const bool into =
        target.place == DropPlace::kGap || (target.place == DropPlace::kNode && !request_.replace);
    if (into && node.shape == Shape::kSubTree) {
      return Problem{"a SubTree has one root: drop it into a node of " + std::string(node.id)};
    }
    Spot spot{place->path, {DropSpot::Kind::kInto, place->element, UINT32_MAX}};
    if (target.place == DropPlace::kGap) spot.at.position = target.index;
    if (target.place == DropPlace::kEdge) spot.at.kind = DropSpot::Kind::kAround;
    if (target.place == DropPlace::kNode && request_.replace) {
      spot.at.kind = DropSpot::Kind::kReplace;
    }
    return spot;
  }

  // The dragged elements; a problem if they are of another file.
  Expected<std::vector<ElementIndex>> What(const std::string& path) const {
    std::vector<ElementIndex> elements;
    for (const std::uint32_t node : drag_.nodes) {
      const auto place = state_.workspace.PlaceOf(scene_.nodes[node]);
      if (!place || place->path != path) {
        return Problem{"nodes of another file: cut and paste them"};
      }
      elements.push_back(place->element);
    }
    return elements;
  }

 private:
  const EditorState& state_;
  const Drag& drag_;
  const DropRequest& request_;
  const Scene& scene_;
};

// New nodes as XML: those of the tile of types, or copies.
std::vector<std::string> Fragments(const EditorState& state, const Document& document,
                                   const std::vector<ElementIndex>& elements) {
  if (elements.empty()) return {state.drag.xml};
  Diagnostics diagnostics;
  return ReadFragments(CopyText(document, elements), diagnostics);
}

Outcome Apply(const EditorState& state, const Drag& drag, const DropRequest& request,
              const Spot& spot, const std::vector<ElementIndex>& elements, Draft& draft,
              const NodeRules& rules) {
  if (!drag.nodes.empty() && !request.copy) return DropMoved(draft, rules, spot.at);
  return DropNew(draft, rules, spot.at, Fragments(state, draft.document(), elements));
}

// Tries it on a copy.
Outcome Try(EditorState& state, const Drag& drag, const DropRequest& request, double now) {
  if (Outcome can = TreeEditor(state, now).CanEdit(); !can) return can;
  const Translation translation(state, drag, request);
  const auto spot = translation.Where();
  if (!spot) return Problem{spot.problem()};
  const auto elements = translation.What(spot->path);
  if (!elements) return Problem{elements.problem()};
  Draft draft(*state.workspace.project().Find(spot->path)->document, *elements);
  const NodeRules rules(*state.workspace.file()->models);
  return Apply(state, drag, request, *spot, *elements, draft, rules);
}

// Asked in every frame, so the last answer is kept.
std::string WhyNot(EditorState& state, const Drag& drag, const DropRequest& request, double now) {
  DropAnswer& last = state.drag.answer;
  const std::uint64_t version = state.workspace.project().version();
  if (last.version == version && last.label == drag.label && last.target == request.target &&
      last.copy == request.copy && last.replace == request.replace) {
    return last.refusal;
  }
  last = {version,      drag.label,      request.target,
          request.copy, request.replace, Try(state, drag, request, now).problem()};
  return last.refusal;
}

void Drop(EditorState& state, const Drag& drag, const DropRequest& request, double now) {
  const Translation translation(state, drag, request);
  const auto spot = translation.Where();
  if (!spot) return state.Notify(spot.problem(), now, true);
  const auto elements = translation.What(spot->path);
  if (!elements) return state.Notify(elements.problem(), now, true);
  const bool is_new = drag.nodes.empty();
  const std::string name = (is_new ? "Add " : request.copy ? "Copy " : "Move ") + drag.label;
  const std::vector<ElementIndex> about = is_new ? std::vector{spot->at.element} : *elements;
  TreeEditor(state, now).RunOn(name, spot->path, about, [&](Draft& draft, const NodeRules& rules) {
    return Apply(state, drag, request, *spot, *elements, draft, rules);
  });
}

}  // namespace

NodeDrop::NodeDrop(EditorState& state, double now) {
  handler_.why_not = [&state, now](const Drag& drag, const DropRequest& request) {
    return WhyNot(state, drag, request, now);
  };
  handler_.drop = [&state, now](const Drag& drag, const DropRequest& request) {
    state.after_frame = [&state, drag, request, now] { Drop(state, drag, request, now); };
  };
  handler_.incoming = state.drag.carried ? &*state.drag.carried : nullptr;
}

}  // namespace coppice::editor
