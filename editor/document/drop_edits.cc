#include "editor/document/drop_edits.h"

#include <optional>
#include <utility>

#include "bt_core/model/element_edits.h"
#include "editor/document/fragment.h"
#include "editor/document/tree_edits.h"

namespace coppice::editor {
namespace {

constexpr char kNoSceneNode[] = "this is no node";
constexpr char kMalformed[] = "the result would not be well-formed XML";

std::string TextOf(const Document& document, ElementIndex index) {
  return CopyText(document, {index});
}

// The fragment with the element as its last child.
Expected<std::string> Around(const Document& document, const NodeRules& rules, ElementIndex element,
                             const std::string& fragment) {
  Diagnostics problems;
  const auto outer = Document::FromText(fragment, "dropped", problems);
  if (!outer) return Problem{kMalformed};
  if (const Outcome room = rules.HasRoom(*outer, kRootElement, 1); !room) {
    return Problem{room.problem()};
  }
  std::string inner = TextOf(document, element);
  inner.pop_back();  // the line end
  const auto both = outer->Edited(InsertElement(*outer, kRootElement, UINT32_MAX, inner), problems);
  if (!both) return Problem{kMalformed};
  return both->text();
}

// What stands in the place of the element afterwards.
Outcome Put(Draft& draft, const Edit& edit, ElementIndex element) {
  draft.Select({element});
  return draft.Apply(edit) ? Outcome() : Problem{kMalformed};
}

Outcome DropAround(Draft& draft, const NodeRules& rules, ElementIndex element,
                   const std::string& fragment, Edit removal) {
  const auto both = Around(draft.document(), rules, element, fragment);
  if (!both) return Problem{both.problem()};
  return Put(draft, Merge(std::move(removal), ReplaceElement(draft.document(), element, *both)),
             element);
}

}  // namespace

Outcome DropNew(Draft& draft, const NodeRules& rules, const DropSpot& spot,
                const std::vector<std::string>& fragments) {
  if (spot.kind == DropSpot::Kind::kInto) {
    return InsertNodes(draft, rules, spot.element, spot.position, fragments);
  }
  if (fragments.size() != 1) return Problem{"one node at a time"};
  if (!IsNode(draft.document(), spot.element)) return Problem{kNoSceneNode};
  if (spot.kind == DropSpot::Kind::kAround) {
    return DropAround(draft, rules, spot.element, fragments[0], {});
  }
  Diagnostics problems;
  const auto dropped = Document::FromText(fragments[0], "dropped", problems);
  const bool has_children = draft.document().element(spot.element).child_count > 0;
  if (dropped && has_children && dropped->elements().size() == 1 &&
      dropped->element(kRootElement).tag != "SubTree") {
    draft.Select({spot.element});
    return ChangeType(draft, rules, dropped->element(kRootElement).tag);
  }
  return Put(draft, ReplaceElement(draft.document(), spot.element, fragments[0]), spot.element);
}

Outcome DropMoved(Draft& draft, const NodeRules& rules, const DropSpot& spot) {
  const Document& document = draft.document();
  if (spot.kind == DropSpot::Kind::kInto) {
    return MoveInto(draft, rules, spot.element, spot.position);
  }
  const std::vector<ElementIndex> nodes = Topmost(document, draft.selection());
  if (nodes.size() != 1) return Problem{"one node at a time"};
  if (!IsNode(document, nodes[0]) || !IsNode(document, spot.element)) return Problem{kNoSceneNode};
  const bool inside = LiesIn(document, spot.element, nodes[0]);
  if (inside || LiesIn(document, nodes[0], spot.element)) {
    return Problem{inside ? "a node cannot be moved into itself" : "it is in that branch already"};
  }
  std::string text = TextOf(document, nodes[0]);
  text.pop_back();  // the line end
  Edit removal = RemoveElement(document, nodes[0]);
  if (spot.kind == DropSpot::Kind::kAround) {
    return DropAround(draft, rules, spot.element, text, std::move(removal));
  }
  return Put(draft, Merge(std::move(removal), ReplaceElement(document, spot.element, text)),
             spot.element);
}

}  // namespace coppice::editor
