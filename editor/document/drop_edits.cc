#include "editor/document/drop_edits.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "bt_core/model/element_edits.h"
#include "editor/document/tree_edits.h"

namespace coppice::editor {
namespace {

constexpr char kNothing[] = "nothing is selected";

std::vector<std::string> TextsOf(const Document& document,
                                 const std::vector<ElementIndex>& elements) {
  std::vector<std::string> texts;
  for (const ElementIndex index : elements) {
    const Element& element = document.element(index);
    texts.push_back(document.text().substr(element.offset, element.end - element.offset));
  }
  return texts;
}

std::string Problem(const Draft& draft) {
  return draft.problems().all().empty() ? "the result would not be well-formed XML"
                                        : draft.problems().all().back().message;
}

}  // namespace

std::string CopyInto(Draft& draft, const NodeRules& rules, ElementIndex parent,
                     std::uint32_t position) {
  const auto nodes = Topmost(draft.document(), draft.selection());
  if (nodes.empty()) return kNothing;
  return InsertNodes(draft, rules, parent, position, TextsOf(draft.document(), nodes));
}

std::string PutAround(Draft& draft, const NodeRules& rules, ElementIndex inner) {
  const Document& document = draft.document();
  const auto nodes = Topmost(document, draft.selection());
  if (nodes.empty()) return kNothing;
  if (nodes.size() > 1) return "only one node can go around another";
  const ElementIndex outer = nodes.front();
  if (outer == inner) return "a node cannot be moved into itself";
  if (LiesIn(document, inner, outer) || LiesIn(document, outer, inner)) {
    return "one of the two lies in the other";
  }
  const std::string refusal = rules.WhyNoRoom(document, outer, 1);
  if (!refusal.empty()) return refusal;
  const ElementIndex parent = document.element(inner).parent;
  const std::uint32_t position = PositionOf(document, inner);
  // Both are followed; which of them comes first does not change.
  const bool parent_first = parent < outer;
  draft.Select({parent, outer});
  if (!draft.Move(inner, outer, UINT32_MAX)) return Problem(draft);
  const std::vector<ElementIndex> both = draft.selection();
  draft.Select({both[parent_first ? 1 : 0]});
  return MoveInto(draft, rules, both[parent_first ? 0 : 1], position);
}

std::string TakePlaceOf(Draft& draft, const NodeRules& rules, ElementIndex old) {
  const Document& document = draft.document();
  const auto nodes = Topmost(document, draft.selection());
  if (nodes.empty()) return kNothing;
  for (const ElementIndex node : nodes) {
    if (LiesIn(document, old, node)) return "a node cannot take the place of what lies in it";
  }
  const std::vector<std::string> texts = TextsOf(document, nodes);
  std::vector<ElementIndex> gone = nodes;
  gone.push_back(old);
  gone = Topmost(document, std::move(gone));
  const ElementIndex parent = document.element(old).parent;
  std::uint32_t position = PositionOf(document, old);
  Edit removal;
  for (const ElementIndex element : gone) {
    const bool before = document.element(element).parent == parent && element < old;
    if (before) --position;
    removal = Merge(std::move(removal), RemoveElement(document, element));
  }
  draft.Select({parent});
  if (!draft.Apply(removal)) return Problem(draft);
  return InsertNodes(draft, rules, draft.selection().front(), position, texts);
}

}  // namespace coppice::editor
