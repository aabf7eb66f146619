// The half of subtree_edits.h that puts a tree in the place of a SubTree.
#include <map>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/keys.h"
#include "bt_core/model/layout.h"
#include "bt_core/model/upgrade.h"
#include "bt_core/model/xml_text.h"
#include "bt_core/nodes/guards.h"
#include "editor/document/key_names.h"
#include "editor/document/subtree_edits.h"

namespace coppice::editor {
namespace {

class Inliner {
 public:
  Inliner(Draft& draft, const NodeRules& rules, ElementIndex subtree, const Document& from,
          ElementIndex root)
      : draft_(draft), rules_(rules), subtree_(subtree), from_(from), root_(root) {
    const Document& document = draft.document();
    for (KeyName& name : KeyNamesIn(document, rules.models(), TreeOf(document, subtree))) {
      if (!name.is_global) around_.insert(std::move(name.key));
    }
  }

  Outcome Run() {
    if (Outcome guards = CheckGuards(); !guards) return guards;
    if (Outcome renamed = RenameKeys(); !renamed) return renamed;
    const std::vector<std::pair<std::string, std::string>> carried = Carried();
    draft_.Select({subtree_});
    if (!draft_.Apply(ReplaceElement(draft_.document(), subtree_, Body()))) return Malformed();
    const ElementIndex made = draft_.selection().front();
    for (const auto& [name, value] : carried) {
      if (draft_.document().FindAttribute(draft_.document().element(made), name)) continue;
      if (!draft_.Apply(SetAttribute(draft_.document(), made, name, value))) return Malformed();
    }
    return {};
  }

 private:
  static Problem Malformed() { return {"the result would not be well-formed XML"}; }

  static bool HasScript(const Document& document, ElementIndex element) {
    for (const std::string_view name : kGuardAttributes) {
      if (document.FindAttribute(document.element(element), name)) return true;
    }
    return false;
  }

  // The guards of one node are asked in an order of their own, so those of two cannot become one's.
  Outcome CheckGuards() const {
    if (!HasScript(draft_.document(), subtree_) || !HasScript(from_, root_)) return {};
    return Problem{
        "the SubTree and its root both have guards or hooks: wrap the root in a node first"};
  }

  Outcome RenameKeys() {
    const bool is_format_3 = IsFormat3(draft_.document());
    bool renamed = false;
    for (const KeyName& name : KeyNamesIn(from_, rules_.models(), root_)) {
      if (name.is_global) continue;
      const Attribute* given =
          draft_.document().FindAttribute(draft_.document().element(subtree_), name.key);
      const std::string_view outer =
          given ? KeyHandedOn(draft_.document().element(subtree_), *given, is_format_3) : "";
      if (given && outer.empty()) {
        if (Outcome put = PutLiteral(name, given->value); !put) return put;
        continue;
      }
      const std::string key = given ? std::string(outer) : PrivateKey(name.key);
      if (key == name.key) continue;
      renamed = true;
      edit_ = Merge(std::move(edit_), {WithKey(name, key)});
    }
    return renamed ? CheckAutoremap() : Outcome();
  }

  std::string PrivateKey(const std::string& key) {
    if (IsAutoremapped(draft_.document(), draft_.document().element(subtree_)) &&
        !IsPrivateKey(key)) {
      return key;
    }
    const auto known = private_.find(key);
    if (known != private_.end()) return known->second;
    std::string fresh = key;
    const std::string tree(TypeOf(draft_.document(), subtree_));
    for (int i = 1; around_.count(fresh) > 0; ++i) {
      fresh = key + "_" + (i == 1 ? "inner" : std::to_string(i));
    }
    around_.insert(fresh);
    return private_[key] = fresh;
  }

  Outcome PutLiteral(const KeyName& name, std::string_view literal) {
    const std::string node(NameOf(from_, name.element));
    if (name.form == KeyForm::kScript) {
      return Problem{"the port " + name.key + " is the literal \"" + std::string(literal) +
                     "\", and a script of " + node + " uses it"};
    }
    if (name.writes) {
      return Problem{"the port " + name.key + " is a literal, and " + node + " writes it"};
    }
    const char quote = from_.text()[name.begin - 1];
    edit_ = Merge(std::move(edit_),
                  {Replacement(name.begin, name.end, EscapeXmlValue(literal, quote))});
    return {};
  }

  // It has the keys by their names.
  Outcome CheckAutoremap() const {
    for (ElementIndex i = root_; i < EndOfBranch(from_, root_); ++i) {
      if (from_.element(i).tag == "SubTree" && IsAutoremapped(from_, from_.element(i))) {
        return Problem{"keys would change their names, and " + std::string(NameOf(from_, i)) +
                       " inside has _autoremap"};
      }
    }
    return {};
  }

  // Name, guards and hooks of the SubTree go to what takes its place.
  std::vector<std::pair<std::string, std::string>> Carried() const {
    std::vector<std::pair<std::string, std::string>> carried;
    const Document& document = draft_.document();
    const Element& element = document.element(subtree_);
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (a->name != "name" && !IsGuardAttribute(a->name)) continue;
      carried.emplace_back(a->name, a->value);
    }
    return carried;
  }

  std::string Body() const {
    const Element& root = from_.element(root_);
    const std::string after = Apply(edit_, from_.text());
    const std::uint32_t begin = root.offset;
    const std::size_t end = root.end + after.size() - from_.text().size();
    const auto indentation = IndentationAt(from_.text(), begin);
    return Reindent(after.substr(begin, end - begin), indentation.value_or(""), "",
                    LineEndAt(draft_.document().text(), 0));
  }

  Draft& draft_;
  const NodeRules& rules_;
  const ElementIndex subtree_;
  const Document from_;
  const ElementIndex root_;
  std::set<std::string> around_;  // keys that are taken
  std::map<std::string, std::string> private_;
  Edit edit_;  // of from_
};

}  // namespace

Outcome InlineSubTree(Draft& draft, const NodeRules& rules, const Document& from,
                      ElementIndex tree) {
  const std::vector<ElementIndex> nodes = Topmost(draft.document(), draft.selection());
  if (nodes.size() != 1 || draft.document().element(nodes[0]).tag != "SubTree" ||
      !IsNode(draft.document(), nodes[0])) {
    return Problem{"select a SubTree"};
  }
  const ElementIndex root = from.element(tree).first_child;
  if (root == kNoElement) return Problem{"that tree is empty"};
  const ElementIndex own = TreeOf(draft.document(), nodes[0]);
  if (from.file() == draft.document().file() && own == tree)
    return Problem{"a tree is not put into itself"};
  return Inliner(draft, rules, nodes[0], from, root).Run();
}

}  // namespace coppice::editor
