// A command on several nodes is one edit of many splices, or several edits one after another. In
// the second case element numbers must stay good between them: each function goes from the last
// node to the first, or takes out everything before it puts anything in.
#include "editor/document/tree_edits.h"

#include <algorithm>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"

namespace coppice::editor {
namespace {

constexpr char kNothing[] = "nothing is selected";
constexpr char kMalformed[] = "the result would not be well-formed XML";

Outcome Applied(bool good, const Draft& draft) {
  if (good) return {};
  const auto& problems = draft.problems().all();
  return Problem{problems.empty() ? kMalformed : problems.back().message};
}

// The selected nodes without those that lie in others.
std::vector<ElementIndex> Nodes(const Draft& draft) {
  std::vector<ElementIndex> nodes = Topmost(draft.document(), draft.selection());
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(),
                             [&](ElementIndex i) { return !IsNode(draft.document(), i); }),
              nodes.end());
  return nodes;
}

ElementIndex ParentOf(const Draft& draft, ElementIndex element) {
  return draft.document().element(element).parent;
}

bool IsSelected(const std::vector<ElementIndex>& nodes, ElementIndex element) {
  return std::find(nodes.begin(), nodes.end(), element) != nodes.end();
}

// Where the user goes on when these are gone.
ElementIndex NeighbourOf(const Document& document, const std::vector<ElementIndex>& gone) {
  const ElementIndex first = gone.front();
  for (ElementIndex i = document.element(gone.back()).next_sibling; i != kNoElement;
       i = document.element(i).next_sibling) {
    if (!IsSelected(gone, i)) return i;
  }
  const ElementIndex before = SiblingBefore(document, first);
  if (before != kNoElement && !IsSelected(gone, before)) return before;
  return document.element(first).parent;
}

}  // namespace

Outcome InsertNodes(Draft& draft, const NodeRules& rules, ElementIndex parent,
                    std::uint32_t position, const std::vector<std::string>& fragments) {
  const auto count = static_cast<std::uint32_t>(fragments.size());
  if (count == 0) return Problem{"there is nothing to insert"};
  if (Outcome room = rules.HasRoom(draft.document(), parent, count); !room) return room;
  position = std::min(position, draft.document().element(parent).child_count);
  for (std::uint32_t i = 0; i < count; ++i) {
    // What is inserted lies behind the parent's '<', so its number stays.
    if (!draft.Apply(InsertElement(draft.document(), parent, position + i, fragments[i]))) {
      return Applied(false, draft);
    }
  }
  std::vector<ElementIndex> inserted;
  for (std::uint32_t i = 0; i < count; ++i) {
    inserted.push_back(ChildAt(draft.document(), parent, position + i));
  }
  draft.Select(inserted);
  return {};
}

Outcome DeleteNodes(Draft& draft) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  Edit edit;
  for (const ElementIndex node : nodes) {
    edit = Merge(std::move(edit), RemoveElement(draft.document(), node));
  }
  draft.Select({NeighbourOf(draft.document(), nodes)});
  return Applied(draft.Apply(edit), draft);
}

Outcome DeleteKeepingChildren(Draft& draft, const NodeRules& rules) {
  // From the last to the first: what is before an edit keeps its number.
  std::vector<ElementIndex> nodes = draft.selection();
  if (nodes.empty()) return Problem{kNothing};
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    const Document& document = draft.document();
    if (!IsNode(document, *node)) return Problem{kNothing};
    const std::uint32_t children = document.element(*node).child_count;
    if (children > 1) {
      Outcome room = rules.HasRoom(document, document.element(*node).parent, children - 1);
      if (!room) return room;
    }
    if (children == 0) draft.Select({NeighbourOf(document, {*node})});
    if (!draft.Apply(UnwrapElement(document, *node))) return Applied(false, draft);
  }
  return {};
}

Outcome MoveAmongSiblings(Draft& draft, int by) {
  std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  draft.Select(nodes);
  if (by > 0) std::reverse(nodes.begin(), nodes.end());
  std::vector<std::uint32_t> positions;  // taken by what could not move
  ElementIndex parent = kNoElement;
  bool moved = false;
  for (const ElementIndex node : nodes) {
    const Document& document = draft.document();
    // Only siblings move past each other, so numbers of other branches stay; of these nodes too,
    // for each moves away from those that are still to come.
    if (ParentOf(draft, node) != parent) positions.clear();
    parent = ParentOf(draft, node);
    const std::uint32_t at = PositionOf(document, node);
    const std::uint32_t last = document.element(parent).child_count - 1;
    const bool at_edge = by < 0 ? at == 0 : at == last;
    const std::uint32_t to = at + static_cast<std::uint32_t>(by);
    if (at_edge || std::find(positions.begin(), positions.end(), to) != positions.end()) {
      positions.push_back(at);
      continue;
    }
    if (!draft.Move(node, parent, to)) return Applied(false, draft);
    moved = true;
    positions.push_back(to);
  }
  if (moved) return {};
  return Problem{by < 0 ? "it is the first already" : "it is the last already"};
}

Outcome Promote(Draft& draft, const NodeRules& rules) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  const ElementIndex parent = ParentOf(draft, nodes.front());
  if (!IsNode(draft.document(), parent)) return Problem{"it is the root already"};
  return MoveInto(draft, rules, ParentOf(draft, parent), PositionOf(draft.document(), parent) + 1);
}

Outcome Demote(Draft& draft, const NodeRules& rules) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  const Document& document = draft.document();
  const auto count = static_cast<std::uint32_t>(nodes.size());
  const ElementIndex before = SiblingBefore(document, nodes.front());
  const ElementIndex behind = document.element(nodes.back()).next_sibling;
  if (before != kNoElement && rules.HasRoom(document, before, count)) {
    return MoveInto(draft, rules, before, UINT32_MAX);
  }
  if (behind != kNoElement && rules.HasRoom(document, behind, count)) {
    return MoveInto(draft, rules, behind, 0);
  }
  return Problem{"no neighbour takes it as a child"};
}

Outcome MoveInto(Draft& draft, const NodeRules& rules, ElementIndex parent,
                 std::uint32_t position) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  const Document& document = draft.document();
  std::uint32_t coming = 0;
  std::uint32_t before = 0;  // those that leave a place before the position
  for (const ElementIndex node : nodes) {
    if (LiesIn(document, parent, node)) return Problem{"a node cannot be moved into itself"};
    if (ParentOf(draft, node) != parent) {
      ++coming;
    } else if (PositionOf(document, node) < position) {
      ++before;
    }
  }
  if (coming > 0) {
    if (Outcome room = rules.HasRoom(document, parent, coming); !room) return room;
  }
  // Taken out first, all together: then no move can disturb another.
  std::vector<std::string> fragments;
  Edit removal;
  for (const ElementIndex node : nodes) {
    fragments.push_back(document.text().substr(
        document.element(node).offset, document.element(node).end - document.element(node).offset));
    removal = Merge(std::move(removal), RemoveElement(document, node));
  }
  if (nodes.size() == 1) {
    draft.Select(nodes);
    const std::uint32_t to = std::min(position, document.element(parent).child_count) - before;
    return Applied(draft.Move(nodes[0], parent, to), draft);
  }
  draft.Select({parent});
  position = std::min(position, document.element(parent).child_count) - before;
  if (!draft.Apply(removal)) return Applied(false, draft);
  return InsertNodes(draft, rules, draft.selection().front(), position, fragments);
}

Outcome Wrap(Draft& draft, const NodeRules& rules, std::string_view xml) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  const Document& document = draft.document();
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (document.element(nodes[i - 1]).next_sibling != nodes[i]) {
      return Problem{"only neighbours can be wrapped together"};
    }
  }
  Diagnostics problems;
  const auto wrapper = Document::FromText(std::string(xml), "wrapper", problems);
  if (!wrapper) return Problem{problems.all().front().message};
  const auto count = static_cast<std::uint32_t>(nodes.size());
  if (Outcome room = rules.HasRoom(*wrapper, kRootElement, count); !room) return room;
  draft.Select({nodes.front()});
  if (!draft.Apply(
          WrapElements(document, nodes.front(), count, wrapper->element(kRootElement).tag))) {
    return Applied(false, draft);
  }
  const ElementIndex made = nodes.front();  // it has the number of the first that it wraps
  const Element& element = wrapper->element(kRootElement);
  for (const Attribute* a = wrapper->attributes_begin(element);
       a != wrapper->attributes_end(element); ++a) {
    if (!draft.Apply(SetAttribute(draft.document(), made, a->name, a->value))) {
      return Applied(false, draft);
    }
  }
  draft.Select({made});
  return {};
}

std::vector<std::string> LostByChange(const Document& document, const NodeRules& rules,
                                      ElementIndex index, std::string_view type) {
  std::vector<std::string> lost;
  const NodeModel* model = rules.models().Find(type);
  if (!model) return lost;
  const Element& element = document.element(index);
  for (const Attribute* a = document.attributes_begin(element);
       a != document.attributes_end(element); ++a) {
    if (IsReservedAttribute(a->name) || model->FindPort(a->name)) continue;
    lost.emplace_back(a->name);
  }
  return lost;
}

Outcome ChangeType(Draft& draft, const NodeRules& rules, std::string_view type) {
  if (!IsXmlName(type))
    return Problem{"\"" + std::string(type) + "\" cannot be the name of a type"};
  const std::vector<ElementIndex> nodes = draft.selection();
  if (nodes.empty()) return Problem{kNothing};
  for (const ElementIndex node : nodes) {
    if (!IsNode(draft.document(), node)) return Problem{kNothing};
    const std::uint32_t limit = rules.MaxChildrenOf(type);
    if (draft.document().element(node).child_count > limit) {
      return Problem{std::string(type) + (limit == 0 ? " takes no children" : " takes one child")};
    }
    for (const std::string& name : LostByChange(draft.document(), rules, node, type)) {
      if (!draft.Apply(RemoveAttribute(draft.document(), node, name))) {
        return Applied(false, draft);
      }
    }
    // <Action ID="Say"/> becomes <Shout/>: the short form holds for every category.
    if (draft.document().FindAttribute(draft.document().element(node), "ID") &&
        !draft.Apply(RemoveAttribute(draft.document(), node, "ID"))) {
      return Applied(false, draft);
    }
    if (!draft.Apply(SetTag(draft.document(), node, type))) return Applied(false, draft);
  }
  return {};
}

namespace {

constexpr std::string_view kSkip = "true";
constexpr std::string_view kSkipElse = "true || (";

const Attribute* SkipIf(const Document& document, ElementIndex element) {
  return document.FindAttribute(document.element(element), "_skipIf");
}

Edit Disabling(const Document& document, ElementIndex node) {
  const Attribute* skip = SkipIf(document, node);
  if (!skip) return SetAttribute(document, node, "_skipIf", kSkip);
  return {Replacement(skip->value_offset, skip->value_offset, std::string(kSkipElse)),
          Replacement(skip->value_end, skip->value_end, ")")};
}

Edit Enabling(const Document& document, ElementIndex node) {
  const Attribute* skip = SkipIf(document, node);
  if (document.RawValue(*skip) == kSkip) return RemoveAttribute(document, node, "_skipIf");
  return {Replacement(skip->value_offset, skip->value_offset + kSkipElse.size(), ""),
          Replacement(skip->value_end - 1, skip->value_end, "")};
}

}  // namespace

bool IsDisabled(const Document& document, ElementIndex element) {
  const Attribute* skip = SkipIf(document, element);
  if (!skip) return false;
  const std::string_view raw = document.RawValue(*skip);
  return raw == kSkip || (raw.substr(0, kSkipElse.size()) == kSkipElse && raw.back() == ')');
}

Outcome ToggleDisabled(Draft& draft) {
  const std::vector<ElementIndex> nodes = Nodes(draft);
  if (nodes.empty()) return Problem{kNothing};
  const Document& document = draft.document();
  const bool all = std::all_of(nodes.begin(), nodes.end(),
                               [&](ElementIndex node) { return IsDisabled(document, node); });
  Edit edit;
  for (const ElementIndex node : nodes) {
    if (!all && IsDisabled(document, node)) continue;
    const Attribute* skip = SkipIf(document, node);
    if (!all && skip && skip->value.find(';') != std::string_view::npos) {
      return Problem{"_skipIf of " + std::string(NameOf(document, node)) +
                     " has several statements"};
    }
    edit = Merge(std::move(edit), all ? Enabling(document, node) : Disabling(document, node));
  }
  return Applied(draft.Apply(edit), draft);
}

Outcome SetValue(Draft& draft, std::string_view attribute, std::string_view value) {
  if (!IsXmlName(attribute)) return Problem{"\"" + std::string(attribute) + "\" is no name"};
  if (attribute == "name" && value.empty()) return ClearValue(draft, attribute);
  const std::vector<ElementIndex> elements = draft.selection();
  if (elements.empty()) return Problem{kNothing};
  Edit edit;
  for (const ElementIndex element : elements) {
    edit = Merge(std::move(edit), SetAttribute(draft.document(), element, attribute, value));
  }
  return Applied(draft.Apply(edit), draft);
}

Outcome ClearValue(Draft& draft, std::string_view attribute) {
  const std::vector<ElementIndex> elements = draft.selection();
  if (elements.empty()) return Problem{kNothing};
  Edit edit;
  for (const ElementIndex element : elements) {
    edit = Merge(std::move(edit), RemoveAttribute(draft.document(), element, attribute));
  }
  return Applied(draft.Apply(edit), draft);
}

}  // namespace coppice::editor
