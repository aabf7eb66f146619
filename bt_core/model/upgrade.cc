// Upgrading is an Edit, not a second writer of XML: what format 4 calls the same stays byte for
// byte, and the user sees in the difference what was changed. A file without a declared format may
// be of either; what it uses tells.
#include "bt_core/model/upgrade.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/layout.h"
#include "bt_core/model/manifest.h"
#include "bt_core/model/node_model.h"
#include "bt_core/model/upgrade_check.h"

namespace coppice {
namespace {

struct NewName {
  std::string_view old;
  std::string_view now;
};

constexpr NewName kNodes[] = {{"SequenceStar", "SequenceWithMemory"},
                              {"FallbackStar", "Fallback"},
                              {"RetryUntilSuccesful", "RetryUntilSuccessful"}};

constexpr NewName kParallelPorts[] = {{"threshold", "success_count"},
                                      {"success_threshold", "success_count"},
                                      {"failure_threshold", "failure_count"}};

constexpr std::string_view kGuards[] = {"_failureIf", "_successIf", "_skipIf",   "_while",
                                        "_onSuccess", "_onFailure", "_onHalted", "_post"};

constexpr std::string_view kNodesOfFormat4[] = {
    "Script",         "ScriptCondition", "SequenceWithMemory",
    "AsyncSequence",  "AsyncFallback",   "Precondition",
    "RunOnce",        "UnsetBlackboard", "SkipUnlessUpdated",
    "WaitValueUpdate"};

template <class Names>
std::string_view FindNew(const Names& names, std::string_view old) {
  for (const NewName& name : names) {
    if (name.old == old) return name.now;
  }
  return {};
}

template <class Names>
bool Contains(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool IsTrue(std::string_view value) { return value == "1" || value == "true" || value == "TRUE"; }

// In a tree, "<Control ID="SequenceStar">" and "<SequenceStar>" are the same.
std::string_view TypeOf(const Document& document, const Element& element) {
  const bool is_explicit = CategoryFromTag(element.tag) && element.tag != "SubTree";
  return is_explicit ? document.AttributeValue(element, "ID") : element.tag;
}

// A port of a SubTree: neither its ID nor for the engine or an editor.
bool IsPort(const Attribute& attribute) { return !IsReservedAttribute(attribute.name); }

bool IsPointer(std::string_view value) {
  return value.size() > 1 && value.front() == '{' && value.back() == '}';
}

bool IsOfFormat3(const Document& document, const Element& element) {
  const std::string_view type = TypeOf(document, element);
  return type == "SubTreePlus" || !FindNew(kNodes, type).empty() || IsBlackboardCheck(type) ||
         document.FindAttribute(element, "__shared_blackboard") ||
         document.FindAttribute(element, "__autoremap");
}

bool IsOfFormat4(const Document& document, const Element& element) {
  if (Contains(kNodesOfFormat4, TypeOf(document, element))) return true;
  return std::any_of(document.attributes_begin(element), document.attributes_end(element),
                     [&element](const Attribute& a) {
                       return a.name == "_autoremap" || Contains(kGuards, a.name) ||
                              (element.tag == "SubTree" && IsPort(a) && IsPointer(a.value));
                     });
}

class Upgrader {
 public:
  Upgrader(const Document& document, Diagnostics& diagnostics, const TreeNames& trees)
      : document_(document), diagnostics_(diagnostics), trees_(trees.begin(), trees.end()) {}

  Edit Run() {
    Add(SetAttribute(document_, kRootElement, "BTCPP_format", "4"));
    ForEachBelowRoot("BehaviorTree",
                     [this](ElementIndex i) { trees_.insert(IdOf(document_.element(i))); });
    ForEachBelowRoot("TreeNodesModel", [this](ElementIndex i) { ReadModelsIn(i); });
    ForEachBelowRoot("BehaviorTree", [this](ElementIndex i) { UpgradeTree(i); });
    WarnOfOddKeys();
    return Merge(std::move(edit_), {});  // in order
  }

 private:
  template <class Do>
  void ForEachBelowRoot(std::string_view tag, const Do& act) {
    for (ElementIndex i = document_.element(kRootElement).first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      if (document_.element(i).tag == tag) act(i);
    }
  }

  std::string_view IdOf(const Element& element) const {
    return document_.AttributeValue(element, "ID");
  }

  void ReadModelsIn(ElementIndex index) {
    const Element& element = document_.element(index);
    Diagnostics told_later;
    for (const NodeModel& model : ReadModels(document_, element, 0, told_later)) {
      if (model.category == NodeCategory::kSubTree) {
        UpgradeSubTreeModel(model.element);
      } else {
        models_.try_emplace(model.id, model);
      }
    }
  }

  // Groot 1 wrote what it needs itself as if it were ports.
  void UpgradeSubTreeModel(ElementIndex model) {
    for (ElementIndex i = document_.element(model).first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      const std::string_view name = document_.AttributeValue(document_.element(i), "name");
      if (name == "__shared_blackboard" || name == "__autoremap") Add(RemoveElement(document_, i));
    }
  }

  // Elements lie in document order, so those of a tree follow it.
  void UpgradeTree(ElementIndex tree) {
    const std::uint32_t end = document_.element(tree).end;
    for (ElementIndex i = tree + 1;
         i < document_.elements().size() && document_.element(i).offset < end; ++i) {
      UpgradeNode(i);
    }
  }

  void UpgradeNode(ElementIndex index) {
    const Element& element = document_.element(index);
    const std::string_view type = TypeOf(document_, element);
    const std::string_view now = FindNew(kNodes, type);
    if (!now.empty()) {
      Add(type == element.tag ? SetTag(document_, index, now)
                              : SetAttribute(document_, index, "ID", now));
    } else if (type == "SubTree" || type == "SubTreePlus") {
      UpgradeSubTree(index);
    } else if (IsTreeByItsName(element)) {
      Add(SetTag(document_, index, "SubTree"));
      Add(SetAttribute(document_, index, "ID", element.tag));
      UpgradeSubTree(index);
    } else if (type == "Parallel") {
      UpgradeParallel(index);
    } else if (IsBlackboardCheck(type)) {
      Add(UpgradeBlackboardCheck(document_, index, type, diagnostics_));
    } else if (element.tag == "Root" && element.child_count == 1 &&
               document_.element(element.parent).tag == "BehaviorTree") {
      RemoveRoot(element);
    }
    UpgradeOutputs(index, type);
    WarnOfGuards(element);
  }

  // In format 3, a tree may be used as a node type, too.
  bool IsTreeByItsName(const Element& element) const {
    return trees_.count(element.tag) > 0 && models_.find(element.tag) == models_.end() &&
           element.child_count == 0;
  }

  // In format 3, an output writes the key whose name is the text of the port.
  void UpgradeOutputs(ElementIndex index, std::string_view type) {
    const auto model = models_.find(type);
    if (model == models_.end()) return;
    for (const PortModel& port : model->second.ports) {
      const std::string_view key = document_.AttributeValue(document_.element(index), port.name);
      const bool is_plain = !key.empty() && key != "=" && key.find('{') == key.npos;
      if (port.direction != PortDirection::kOutput || !is_plain) continue;
      Add(SetAttribute(document_, index, port.name, "{" + std::string(key) + "}"));
    }
  }

  void UpgradeSubTree(ElementIndex index) {
    const Element& element = document_.element(index);
    UpgradeAutoremap(index);
    if (element.tag == "SubTreePlus") {
      Add(SetTag(document_, index, "SubTree"));
      return;
    }
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      if (IsPort(*a)) UpgradeRemapping(index, *a);
    }
  }

  // One of the two old attributes becomes the new one, unless that is there already.
  void UpgradeAutoremap(ElementIndex index) {
    const Element& element = document_.element(index);
    const bool done = document_.FindAttribute(element, "_autoremap") != nullptr;
    const bool shared = IsTrue(document_.AttributeValue(element, "__shared_blackboard"));
    const auto upgrade = [&](std::string_view old, bool counts) {
      Add(counts && !done ? RenameAttribute(document_, index, old, "_autoremap")
                          : RemoveAttribute(document_, index, old));
    };
    upgrade("__shared_blackboard", shared);
    upgrade("__autoremap", !shared);
  }

  void UpgradeRemapping(ElementIndex index, const Attribute& port) {
    if (IsPointer(port.value)) return;
    if (IsKey(port.value)) {
      Add(SetAttribute(document_, index, port.name, "{" + std::string(port.value) + "}"));
    } else {
      odd_keys_.push_back(&port);
    }
  }

  // A file may have hundreds of them.
  void WarnOfOddKeys() {
    if (odd_keys_.empty()) return;
    const Attribute& first = *odd_keys_.front();
    std::string hint = "in format 3, the attributes of a SubTree name keys";
    if (odd_keys_.size() > 1) {
      hint += "; " + std::to_string(odd_keys_.size() - 1) + " more in this file";
    }
    Warn(first.value_offset,
         "\"" + std::string(first.value) + "\" is no name for a key; it is left as a value", hint);
  }

  void UpgradeParallel(ElementIndex index) {
    const Element& element = document_.element(index);
    for (const NewName& port : kParallelPorts) {
      if (document_.FindAttribute(element, port.now)) continue;
      const bool has_better =
          port.old == "threshold" && document_.FindAttribute(element, "success_threshold");
      if (!has_better) Add(RenameAttribute(document_, index, port.old, port.now));
    }
  }

  // The two tags go, with their lines; what is between them stays as it is.
  void RemoveRoot(const Element& element) {
    const std::size_t end_tag = EndTagOffset(document_, element);
    Add({RemovalOfLine(document_.text(), element.offset, element.start_tag_end),
         RemovalOfLine(document_.text(), end_tag, element.end)});
  }

  void WarnOfGuards(const Element& element) {
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      if (!Contains(kGuards, a->name)) continue;
      Warn(a->name_offset, "in format 4, " + std::string(a->name) + " is a guard with a script",
           "if it is a port of the node, give it another name");
    }
  }

  void Add(const Edit& edit) { edit_.insert(edit_.end(), edit.begin(), edit.end()); }

  void Warn(std::uint32_t offset, std::string message, std::string hint) {
    diagnostics_.Warning(document_.Location(offset), std::move(message), std::move(hint));
  }

  const Document& document_;
  Diagnostics& diagnostics_;
  std::set<std::string_view> trees_;
  std::map<std::string, NodeModel, std::less<>> models_;  // not those of SubTrees
  std::vector<const Attribute*> odd_keys_;
  Edit edit_;
};

}  // namespace

bool IsFormat3(const Document& document) {
  const Attribute* format = document.FindAttribute(document.element(kRootElement), "BTCPP_format");
  if (format) return format->value == "3";
  bool is_4 = false;
  for (const Element& element : document.elements()) {
    if (IsOfFormat3(document, element)) return true;
    is_4 = is_4 || IsOfFormat4(document, element);
  }
  return !is_4;
}

std::string_view NodeNameInFormat4(std::string_view old) { return FindNew(kNodes, old); }

std::string_view PortNameInFormat4(std::string_view type, std::string_view old) {
  return type == "Parallel" ? FindNew(kParallelPorts, old) : std::string_view();
}

Edit UpgradeToFormat4(const Document& document, Diagnostics& diagnostics, const TreeNames& trees) {
  return IsFormat3(document) ? Upgrader(document, diagnostics, trees).Run() : Edit();
}

}  // namespace coppice
