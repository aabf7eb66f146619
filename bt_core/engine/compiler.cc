// Document -> Program. One pass over the elements builds the arrays and resolves every name.
// Positions in the text and words for messages are worked out only when there is something to say.
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "bt_core/engine/keys.h"
#include "bt_core/engine/program.h"

namespace coppice {
namespace {

// SubTrees within SubTrees multiply: a few lines of XML can ask for more than any computer has.
constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::uint32_t kDeepest = 500;

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

class Compiler {
 public:
  Compiler(std::shared_ptr<const Project> project, std::shared_ptr<const Registry> registry,
           Diagnostics& diagnostics)
      : project_(*project), registry_(*registry), diagnostics_(diagnostics) {
    program_->project = std::move(project);
    program_->registry = std::move(registry);
  }

  std::shared_ptr<const Program> Run(const std::string& tree_id) {
    const TreeDefinition* tree = FindMainTree(tree_id);
    if (!tree) return nullptr;
    CheckTreeNames();
    keys_.AddScope(0, false);
    program_->layout.scopes.push_back(tree_id);
    program_->trees.push_back({tree_id, "", 0, 0});
    open_trees_.push_back(tree_id);
    AddTreeBody(*tree, 0, 0);
    keys_.ConvertLiterals();
    GiveBackSpareMemory();
    return diagnostics_.has_errors() ? nullptr : std::move(program_);
  }

 private:
  void GiveBackSpareMemory() {
    program_->nodes.shrink_to_fit();
    program_->ports.shrink_to_fit();
    program_->leaves.shrink_to_fit();
    program_->info.shrink_to_fit();
    program_->layout.slots.shrink_to_fit();
  }

  const TreeDefinition* FindMainTree(const std::string& id) {
    const TreeDefinition* tree = project_.Find(id);
    if (tree) return tree;
    const Document& first = project_.documents().front();
    std::vector<std::string> ids;
    for (const auto& [known, definition] : project_.trees()) ids.push_back(known);
    if (id.empty()) {
      std::string list;
      for (const std::string& known : ids) list += (list.empty() ? "" : ", ") + known;
      diagnostics_.Error(first.Location(first.element(0).offset), "which tree is the main one?",
                         "give main_tree_to_execute; there are: " + list);
    } else {
      const Attribute* asked = first.FindAttribute(first.element(0), "main_tree_to_execute");
      const bool by_file = asked && asked->value == id;
      diagnostics_.Error(first.Location(by_file ? asked->value_offset : first.element(0).offset),
                         "no tree " + Quoted(id), DidYouMean(id, ids));
    }
    return nullptr;
  }

  // A tree and a node type of the same name could not be told apart in the compact form.
  void CheckTreeNames() {
    for (const auto& [id, definition] : project_.trees()) {
      if (!registry_.Find(id)) continue;
      const Document& document = project_.documents()[definition.document];
      const SourceLocation where = document.Location(document.element(definition.element).offset);
      diagnostics_.Error(where, "tree " + Quoted(id) + " has the name of a node type");
    }
  }

  void AddTreeBody(const TreeDefinition& tree, ScopeIndex scope, NodeIndex parent) {
    const Document& document = project_.documents()[tree.document];
    AddNode(tree.document, document.element(tree.element).first_child, scope, parent);
  }

  void AddNode(std::uint32_t doc, ElementIndex index, ScopeIndex scope, NodeIndex parent) {
    const Document& document = project_.documents()[doc];
    const Element& element = document.element(index);
    if (TooBig(document, element)) return;
    const auto node = static_cast<NodeIndex>(program_->nodes.size());

    std::string_view id = element.tag;
    if (CategoryFromTag(element.tag)) {
      id = document.AttributeValue(element, "ID");
      if (id.empty()) {
        Error(document, element, "<" + std::string(element.tag) + "> without ID");
        return;
      }
      if (element.tag == "SubTree") {
        AddSubTree(doc, index, scope, parent, id);
        return;
      }
    }
    const Registry::Entry* entry = registry_.Find(id);
    if (!entry && !registry_.fallback()) {
      Error(document, element, "unknown node type " + Quoted(id), DidYouMean(id, registry_.Ids()));
    } else if (entry && element.tag != id && element.tag != ToString(entry->manifest.category)) {
      diagnostics_.Warning(document.Location(element.offset),
                           Quoted(id) + " is written as <" + std::string(element.tag) + ">",
                           std::string("it is a ") + ToString(entry->manifest.category));
    }
    const NodeType type = entry ? entry->type : NodeType::kLeaf;
    AddRecord(type, entry, doc, index, scope, parent);
    CheckReserved(document, element);
    if (entry) {
      CheckChildCount(*entry, document, element);
      BindPorts(*entry, document, element, scope);
    } else if (element.child_count > 0 && registry_.fallback()) {
      Error(document, element,
            Quoted(id) + " is not built in, so it must be a leaf without children",
            DidYouMean(id, registry_.Ids()));
    }
    if (type == NodeType::kLeaf || type == NodeType::kUser) {
      LeafRecord leaf{node, program_->nodes[node].first_port};
      program_->nodes[node].first_port = static_cast<std::uint32_t>(program_->leaves.size());
      program_->leaves.push_back(leaf);
    }
    ++depth_;
    for (ElementIndex child = element.first_child; child != kNoElement;
         child = document.element(child).next_sibling) {
      AddNode(doc, child, scope, node);
    }
    --depth_;
    program_->nodes[node].end = static_cast<NodeIndex>(program_->nodes.size());
  }

  // True from the first node on that is too much; says so once.
  bool TooBig(const Document& document, const Element& element) {
    const bool deep = depth_ >= kDeepest;
    if (!deep && program_->nodes.size() < kMostNodes) return false;
    if (too_big_) return true;
    too_big_ = true;
    Error(document, element,
          deep ? "nodes are nested more than " + std::to_string(kDeepest) + " deep"
               : "the tree has more than " + std::to_string(kMostNodes) + " nodes",
          "counted with all SubTrees");
    return true;
  }

  void AddSubTree(std::uint32_t doc, ElementIndex index, ScopeIndex scope, NodeIndex parent,
                  std::string_view id) {
    const Document& document = project_.documents()[doc];
    const Element& element = document.element(index);
    const TreeDefinition* tree = project_.Find(id);
    if (!tree) {
      std::vector<std::string> ids;
      for (const auto& [known, definition] : project_.trees()) ids.push_back(known);
      Error(document, element, "no tree " + Quoted(id), DidYouMean(id, ids));
      return;
    }
    if (element.child_count > 0) Error(document, element, "<SubTree> must not have children");
    for (const std::string_view open : open_trees_) {
      if (open != id) continue;
      Error(document, element, "tree " + Quoted(id) + " contains itself");
      return;
    }
    CheckReserved(document, element);
    const auto node = static_cast<NodeIndex>(program_->nodes.size());
    AddRecord(NodeType::kSubTree, registry_.Find("SubTree"), doc, index, scope, parent);
    const ScopeIndex inner = keys_.AddScope(scope, IsTrue(document, element, "_autoremap"));
    const std::string path = program_->Path(node);
    if (!instance_paths_.insert(path).second) {
      Error(document, element,
            "two SubTrees in the same tree have the name " + Quoted(program_->Name(node)),
            "give each a name of its own");
    }
    program_->layout.scopes.push_back(path);
    program_->trees.push_back({std::string(id), path, node + 1, node});
    keys_.Remap(document, element, scope, inner);
    open_trees_.push_back(id);
    ++depth_;
    AddTreeBody(*tree, inner, node);
    --depth_;
    open_trees_.pop_back();
    program_->nodes[node].end = static_cast<NodeIndex>(program_->nodes.size());
  }

  void AddRecord(NodeType type, const Registry::Entry* entry, std::uint32_t doc, ElementIndex index,
                 ScopeIndex scope, NodeIndex parent) {
    const auto node = static_cast<NodeIndex>(program_->nodes.size());
    program_->nodes.push_back(
        {type, type, node + 1, static_cast<std::uint32_t>(program_->ports.size())});
    program_->info.push_back({entry, parent, scope, doc, index});
  }

  // Attributes of the language that this engine does not read must not be ignored silently: a tree
  // that relies on a guard would run without it.
  void CheckReserved(const Document& document, const Element& element) {
    static const std::vector<std::string> guards = {"_failureIf", "_successIf", "_skipIf",
                                                    "_while",     "_onSuccess", "_onFailure",
                                                    "_onHalted",  "_post"};
    static const std::vector<std::string> known = {"_autoremap", "_description", "_collapsed",
                                                   "_uid", "_fullpath"};
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (a->name.substr(0, 1) != "_") continue;
      const auto is = [a](const std::string& name) { return a->name == name; };
      bool ok = false;
      for (const std::string& name : known) ok = ok || is(name);
      bool guard = false;
      for (const std::string& name : guards) guard = guard || is(name);
      const SourceLocation where = document.Location(a->name_offset);
      if (guard) {
        diagnostics_.Error(where, "scripts are not supported yet: " + std::string(a->name));
      } else if (!ok) {
        diagnostics_.Error(where, "unknown attribute " + Quoted(a->name),
                           DidYouMean(a->name, guards));
      }
    }
  }

  void CheckChildCount(const Registry::Entry& entry, const Document& document,
                       const Element& element) {
    const ChildCount allowed = entry.children;
    if (element.child_count >= allowed.min && element.child_count <= allowed.max) return;
    const std::string expected = allowed.max == 0            ? "none"
                                 : allowed.max == UINT32_MAX ? "at least 1"
                                                             : "exactly 1";
    Error(document, element,
          entry.manifest.id + " has " + std::to_string(element.child_count) +
              " children, expected " + expected);
  }

  void BindPorts(const Registry::Entry& entry, const Document& document, const Element& element,
                 ScopeIndex scope) {
    CheckPortNames(entry, document, element);
    for (const PortDeclaration& port : entry.declarations) {
      program_->ports.push_back({BindPort(entry, port, document, element, scope)});
    }
  }

  void CheckPortNames(const Registry::Entry& entry, const Document& document,
                      const Element& element) {
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (IsReservedAttribute(a->name)) continue;
      bool known = false;
      for (const PortDeclaration& port : entry.manifest.ports) known |= a->name == port.name;
      if (known) continue;
      std::vector<std::string> names;
      for (const PortDeclaration& port : entry.manifest.ports) names.push_back(port.name);
      diagnostics_.Error(document.Location(a->name_offset),
                         entry.manifest.id + " has no port " + Quoted(a->name),
                         DidYouMean(a->name, names));
    }
  }

  SlotIndex BindPort(const Registry::Entry& entry, const PortDeclaration& port,
                     const Document& document, const Element& element, ScopeIndex scope) {
    if (port.direction == PortDirection::kMailbox) return keys_.AddSlot("", scope, port.type);
    const Attribute* attribute = document.FindAttribute(element, port.name);
    const std::uint32_t offset = attribute ? attribute->value_offset : element.offset;
    if (!attribute && !port.default_text) {
      if (port.required) {
        Error(document, element, entry.manifest.id + " needs its port " + Quoted(port.name),
              port.description);
      }
      return kNoSlot;
    }
    const std::string_view text = attribute ? attribute->value : *port.default_text;
    const std::string_view key = KeyOf(text, port.name);
    if (!key.empty()) {
      const SlotIndex slot = keys_.Resolve(key, scope);
      keys_.SetType(slot, entry, port, document, offset);
      return slot;
    }
    if (port.direction != PortDirection::kInput) {
      diagnostics_.Error(
          document.Location(offset),
          std::string(ToString(port.direction)) + " " + Quoted(port.name) + " needs a key",
          "write {key}");
      return kNoSlot;
    }
    const SlotIndex slot = keys_.AddSlot("", scope, port.type);
    if (!program_->layout.slots[slot].initial.Parse(*port.type, text)) {
      diagnostics_.Error(document.Location(offset),
                         Quoted(text) + " is not a value for port " + Quoted(port.name) + " of " +
                             entry.manifest.id,
                         std::string("expected ") + port.type->name);
    }
    return slot;
  }

  static bool IsTrue(const Document& document, const Element& element, std::string_view name) {
    bool value = false;
    return ValueTraits<bool>::Parse(document.AttributeValue(element, name), value) && value;
  }

  void Error(const Document& document, const Element& element, std::string message,
             std::string hint = {}) {
    diagnostics_.Error(document.Location(element.offset), std::move(message), std::move(hint));
  }

  const Project& project_;
  const Registry& registry_;
  Diagnostics& diagnostics_;
  std::shared_ptr<Program> program_ = std::make_shared<Program>();
  KeyTable keys_{program_->layout, diagnostics_};
  std::vector<std::string_view> open_trees_;
  std::unordered_set<std::string> instance_paths_;
  std::uint32_t depth_ = 0;
  bool too_big_ = false;
};

}  // namespace

std::shared_ptr<const Program> Compile(std::shared_ptr<const Project> project,
                                       std::shared_ptr<const Registry> registry,
                                       Diagnostics& diagnostics, const std::string& tree_id) {
  const std::string main = tree_id.empty() ? project->main_tree() : tree_id;
  const bool whole = !project->has_errors();
  auto program = Compiler(std::move(project), std::move(registry), diagnostics).Run(main);
  return whole ? program : nullptr;
}

std::shared_ptr<const Program> CompileFile(const std::string& path,
                                           std::shared_ptr<const Registry> registry,
                                           Diagnostics& diagnostics, const std::string& tree_id) {
  std::optional<Project> project = Project::FromFile(path, diagnostics);
  if (!project) return nullptr;
  return Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                 diagnostics, tree_id);
}

}  // namespace coppice
