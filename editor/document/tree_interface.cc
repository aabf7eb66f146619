#include "editor/document/tree_interface.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "bt_core/model/keys.h"
#include "editor/document/key_names.h"

namespace coppice::editor {
namespace {

// What the nodes of a tree do with one of its keys.
struct KeyUsage {
  std::string key;
  std::string type;
  bool reads = false;
  bool writes = false;      // without reading it
  bool updates = false;     // reads and writes it
  std::size_t guesses = 0;  // users that no model describes
};

// Nothing: the key is the tree's own.
std::optional<PortDirection> DirectionOf(const KeyUsage& usage, bool is_given) {
  const bool is_known = usage.reads || usage.writes || usage.updates;
  const bool reads = usage.reads || (usage.guesses > 0 && (is_known || usage.guesses == 1));
  if (usage.updates && !usage.writes) return PortDirection::kInOut;
  if (reads && !usage.writes) return PortDirection::kInput;
  if (usage.writes && !reads) return PortDirection::kOutput;
  if (!is_given) return std::nullopt;
  return usage.writes ? PortDirection::kInOut : PortDirection::kInput;
}

class Finder {
 public:
  Finder(const ProjectFiles& files, const NodeModels& models) : files_(files), models_(models) {}

  const std::vector<InterfacePort>& Of(std::string_view id) {
    const auto [known, is_new] = known_.try_emplace(std::string(id));
    if (is_new) known->second = Find(id);
    return known->second;
  }

 private:
  std::vector<InterfacePort> Find(std::string_view id) {
    std::vector<InterfacePort> ports;
    const std::vector<ElementIn> trees = TreesCalled(files_, id);
    if (trees.empty()) return ports;
    std::set<std::string_view> declared;
    const KnownModel* model = models_.Find(id);
    if (model && model->category == NodeCategory::kSubTree) {
      for (const PortModel& port : model->ports) {
        ports.push_back({port, true});
        declared.insert(port.name);
      }
    }
    const CallersOfTree callers = CallersOf(files_, id);
    for (const KeyUsage& usage : UsagesIn(files_[trees[0].file], trees[0].element)) {
      const auto direction = DirectionOf(usage, callers.ports.count(usage.key) > 0);
      if (!direction || declared.count(usage.key) > 0) continue;
      ports.push_back({{usage.key, *direction, usage.type, "", std::nullopt}, false});
    }
    return ports;
  }

  // By key, in the order of the tree.
  struct Usages {
    std::vector<KeyUsage> list;
    std::unordered_map<std::string, std::size_t> places;

    KeyUsage& Of(const std::string& key) {
      const auto [place, is_new] = places.try_emplace(key, list.size());
      if (is_new) list.emplace_back().key = key;
      return list[place->second];
    }
  };

  std::vector<KeyUsage> UsagesIn(const Document& document, ElementIndex tree) {
    Usages usages;
    for (const KeyName& name : KeyNamesIn(document, models_, tree)) {
      if (name.is_global || IsPrivateKey(name.key)) continue;
      KeyUsage& usage = usages.Of(name.key);
      const std::string_view type = TypeOf(document, name.element);
      if (name.guessed) {
        ++usage.guesses;
      } else if (!name.reads && !name.writes) {
        AddHandedOn(usage, Of(type), name.attribute);
      } else {
        const NodeModel* model = models_.Find(type);
        const PortModel* port = model ? model->FindPort(name.attribute) : nullptr;
        Add(usage, name.reads, name.writes, port ? port->type : "");
      }
    }
    AddAutoremapped(document, tree, usages);
    return std::move(usages.list);
  }

  static void Add(KeyUsage& usage, bool reads, bool writes, const std::string& type) {
    usage.reads = usage.reads || (reads && !writes);
    usage.writes = usage.writes || (writes && !reads);
    usage.updates = usage.updates || (reads && writes);
    const bool says = !type.empty() && type != "script" && type.find("Any") == std::string::npos;
    if (usage.type.empty() && says) usage.type = type;
  }

  static void Add(KeyUsage& usage, const PortModel& port) {
    Add(usage, port.direction != PortDirection::kOutput, port.direction != PortDirection::kInput,
        port.type);
  }

  // To a SubTree, as that port.
  static void AddHandedOn(KeyUsage& usage, const std::vector<InterfacePort>& inner,
                          std::string_view port) {
    const auto at = std::find_if(inner.begin(), inner.end(),
                                 [&](const InterfacePort& one) { return one.model.name == port; });
    if (at == inner.end()) {
      ++usage.guesses;
    } else {
      Add(usage, at->model);
    }
  }

  void AddAutoremapped(const Document& document, ElementIndex tree, Usages& usages) {
    const ElementIndex end = EndOfBranch(document, tree);
    for (ElementIndex i = tree; i < end; ++i) {
      const Element& element = document.element(i);
      if (element.tag != "SubTree" || !IsAutoremapped(document, element)) continue;
      for (const InterfacePort& port : Of(TypeOf(document, i))) {
        if (document.FindAttribute(element, port.model.name)) continue;
        Add(usages.Of(port.model.name), port.model);
      }
    }
  }

  const ProjectFiles& files_;
  const NodeModels& models_;
  // A tree that is being looked into shares nothing yet.
  std::map<std::string, std::vector<InterfacePort>, std::less<>> known_;
};

}  // namespace

std::vector<InterfacePort> InterfaceOf(const ProjectFiles& files, const NodeModels& models,
                                       std::string_view tree) {
  return Finder(files, models).Of(tree);
}

}  // namespace coppice::editor
