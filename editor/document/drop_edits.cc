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

// The fragment with the element as its last child; nothing, with a reason, if it takes none.
std::optional<std::string> Around(const Document& document, const NodeRules& rules,
                                  ElementIndex element, const std::string& fragment,
                                  std::string& refusal) {
  Diagnostics problems;
  const auto outer = Document::FromText(fragment, "dropped", problems);
  if (!outer) {
    refusal = kMalformed;
    return std::nullopt;
  }
  refusal = rules.WhyNoRoom(*outer, kRootElement, 1);
  if (!refusal.empty()) return std::nullopt;
  std::string inner = TextOf(document, element);
  inner.pop_back();  // the line end
  const auto both = outer->Edited(InsertElement(*outer, kRootElement, UINT32_MAX, inner), problems);
  if (!both) {
    refusal = kMalformed;
    return std::nullopt;
  }
  return both->text();
}

// What stands in the place of the element afterwards.
std::string Put(Draft& draft, const Edit& edit, ElementIndex element) {
  draft.Select({element});
  return draft.Apply(edit) ? "" : kMalformed;
}

std::string DropAround(Draft& draft, const NodeRules& rules, ElementIndex element,
                       const std::string& fragment, Edit removal) {
  std::string refusal;
  const auto both = Around(draft.document(), rules, element, fragment, refusal);
  if (!both) return refusal;
  return Put(draft, Merge(std::move(removal), ReplaceElement(draft.document(), element, *both)),
             element);
}

}  // namespace

std::string DropNew(Draft& draft, const NodeRules& rules, const DropSpot& spot,
                    const std::vector<std::string>& fragments) {
  if (spot.kind == DropSpot::Kind::kInto) {
    return InsertNodes(draft, rules, spot.element, spot.position, fragments);
  }
  if (fragments.size() != 1) return "one node at a time";
  if (!IsNode(draft.document(), spot.element)) return kNoSceneNode;
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

std::string DropMoved(Draft& draft, const NodeRules& rules, const DropSpot& spot) {
  const Document& document = draft.document();
  if (spot.kind == DropSpot::Kind::kInto) {
    return MoveInto(draft, rules, spot.element, spot.position);
  }
  const std::vector<ElementIndex> nodes = Topmost(document, draft.selection());
  if (nodes.size() != 1) return "one node at a time";
  if (!IsNode(document, nodes[0]) || !IsNode(document, spot.element)) return kNoSceneNode;
  const bool inside = LiesIn(document, spot.element, nodes[0]);
  if (inside || LiesIn(document, nodes[0], spot.element)) {
    return inside ? "a node cannot be moved into itself" : "it is in that branch already";
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
