// The half of subtree_edits.h that makes a tree of a branch.
#include <algorithm>

#include "bt_core/model/element_edits.h"
#include "bt_core/model/layout.h"
#include "bt_core/model/upgrade.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/key_names.h"
#include "editor/document/subtree_edits.h"

namespace coppice::editor {
namespace {

bool IsBetween(const Document& document, ElementIndex branch, const KeyName& name) {
  return LiesIn(document, name.element, branch);
}

std::string Definition(const Document& document, ElementIndex branch, const std::string& id) {
  const Element& element = document.element(branch);
  const std::string_view line_end = LineEndAt(document.text(), element.offset);
  const auto indentation = IndentationAt(document.text(), element.offset);
  const std::string step(IndentationStep(document, TreeOf(document, branch)));
  const std::string body =
      Reindent(document.text().substr(element.offset, element.end - element.offset),
               indentation.value_or(""), step, line_end);
  return "<BehaviorTree ID=\"" + EscapeXmlValue(id, '"') + "\">" + std::string(line_end) + step +
         body + std::string(line_end) + "</BehaviorTree>";
}

}  // namespace

std::vector<std::string> KeysAcross(const Document& document, const NodeRules& rules,
                                    ElementIndex branch, const CallersOfTree& callers) {
  const auto names = KeyNamesIn(document, rules.models(), TreeOf(document, branch));
  std::vector<std::string> across;
  for (const KeyName& name : names) {
    const bool known = std::find(across.begin(), across.end(), name.key) != across.end();
    if (name.is_global || known || !IsBetween(document, branch, name)) continue;
    bool outside = callers.autoremap || callers.ports.count(name.key) > 0;
    bool written = false;
    bool read = !callers.none;
    for (const KeyName& other : names) {
      if (other.is_global || other.key != name.key) continue;
      const bool inside = IsBetween(document, branch, other);
      outside = outside || !inside;
      written = written || (inside && (other.writes || !other.reads));
      read = read || other.reads || !other.writes;
    }
    if (outside || !written || !read) across.push_back(name.key);
  }
  return across;
}

Outcome ExtractSubTree(Draft& draft, const NodeRules& rules, const std::string& id,
                       const CallersOfTree& callers) {
  const std::vector<ElementIndex> nodes = Topmost(draft.document(), draft.selection());
  if (nodes.size() != 1 || !IsNode(draft.document(), nodes[0])) {
    return Problem{"select one node; several can be wrapped in one first"};
  }
  if (id.empty()) return Problem{"a tree needs a name"};
  const Document& document = draft.document();
  const ElementIndex branch = nodes[0];
  const ElementIndex tree = TreeOf(document, branch);
  const bool is_format_3 = IsFormat3(document);  // in which braces would be part of the key
  std::string use = "<SubTree ID=\"" + EscapeXmlValue(id, '"') + "\"";
  for (const std::string& key : KeysAcross(document, rules, branch, callers)) {
    if (!IsXmlName(key)) return Problem{"the key \"" + key + "\" cannot be the name of a port"};
    use += " " + key + (is_format_3 ? "=\"" + key + "\"" : "=\"{" + key + "}\"");
  }
  use += "/>";
  const Edit edit =
      Merge(ReplaceElement(document, branch, use),
            InsertElement(document, document.element(tree).parent, PositionOf(document, tree) + 1,
                          Definition(document, branch, id)));
  draft.Select({branch});
  if (draft.Apply(edit)) return {};
  return Problem{"the result would not be well-formed XML"};
}

}  // namespace coppice::editor
