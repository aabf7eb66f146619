#include "bt_core/testing/stand_in.h"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/compile/shipped_models.h"
#include "bt_core/engine/compile/type_names.h"
#include "bt_core/model/keys.h"
#include "bt_core/nodes/leaf.h"
#include "bt_core/nodes/user_control.h"

namespace coppice {
namespace {

using Ports = std::vector<PortDeclaration>;

struct Port final : PortBase {
  explicit Port(const PortDeclaration& declaration) : PortBase(declaration) {}
};

class StandIn : public Leaf {
 public:
  static constexpr const char* kDescription = "";
  explicit StandIn(const Ports& ports) : ports_(ports.begin(), ports.end()) {}
  Status Tick(bool) override { throw std::logic_error("only the robot's program has this leaf"); }

 private:
  std::deque<Port> ports_;
};

// It looks on: what it does beside ticking its child only the robot's program knows.
class StandInDecorator : public UserDecorator {
 public:
  static constexpr const char* kDescription = "";
  explicit StandInDecorator(const Ports& ports) : ports_(ports.begin(), ports.end()) {}
  Status Tick(Children& child, bool) override { return child.Tick(0); }

 private:
  std::deque<Port> ports_;
};

// Without a model it may as well be a misspelt node.
class UnknownDecorator final : public StandInDecorator {
 public:
  using StandInDecorator::StandInDecorator;
};

class StandInAction final : public StandIn {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;
  using StandIn::StandIn;
};

class StandInCondition final : public StandIn {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kCondition;
  using StandIn::StandIn;
};

// What a project shows of the leaves and decorators that are not built in.
class Leaves {
 public:
  Leaves(const Project& project, const Project* models, const Registry& known)
      : project_(project), models_(models), known_(known) {
    FindShipped();
    for (const auto& [id, tree] : project.trees()) {
      const Document& document = project.documents()[tree.document];
      const Element& root = document.element(tree.element);
      for (ElementIndex i = tree.element + 1; i < document.elements().size(); ++i) {
        if (document.element(i).offset >= root.end) break;
        Add(document, document.element(i));
      }
    }
  }

  void RegisterAll(Registry& registry) const {
    for (const auto& [id, leaf] : leaves_) {
      try {
        if (leaf.is_decorator && !leaf.has_model) {
          registry.Register<UnknownDecorator>(id, leaf.ports);
        } else if (leaf.is_decorator) {
          registry.Register<StandInDecorator>(id, leaf.ports);
        } else if (leaf.is_condition) {
          registry.Register<StandInCondition>(id, leaf.ports);
        } else {
          registry.Register<StandInAction>(id, leaf.ports);
        }
      } catch (const std::invalid_argument&) {
        continue;  // no type can have such a name: the compiler says so
      }
    }
  }

 private:
  struct Seen {
    bool is_condition = false;
    bool is_decorator = false;
    bool has_model = false;
    Ports ports;
  };

  void Add(const Document& document, const Element& element) {
    const std::string id(IdOf(document, element));
    if (id.empty() || element.child_count > 1 || known_.Find(id)) return;
    const NodeModel* const model = ModelOf(id);
    const auto [at, is_new] = leaves_.try_emplace(id);
    Seen& leaf = at->second;
    leaf.is_decorator = element.child_count == 1;
    leaf.has_model = model != nullptr;
    if (!model) {
      leaf.is_condition = element.tag == "Condition";
      AddAttributes(document, element, leaf.ports);
    } else if (is_new) {
      leaf.is_condition = model->category == NodeCategory::kCondition;
      for (const PortModel& port : model->ports) {
        leaf.ports.push_back({port.name, port.direction, FindType(known_, port.type),
                              port.description, false, port.default_text});
      }
    }
  }

  // Of well-known programs, where nobody else describes a type.
  void FindShipped() {
    std::vector<const Document*> documents;
    for (const Document& document : project_.documents()) documents.push_back(&document);
    const auto is_known = [this](std::string_view id) {
      return known_.Find(id) || ModelOf(std::string(id));
    };
    for (const ShippedTypes& found : FindShippedTypes(documents, is_known)) {
      for (const NodeModel* const type : found.types) shipped_.emplace(type->id, type);
    }
  }

  const NodeModel* ModelOf(const std::string& id) const {
    const auto shipped = shipped_.find(id);
    if (shipped != shipped_.end()) return shipped->second;
    for (const Project* const source : {&project_, models_}) {
      if (!source) continue;
      const auto found = source->models().find(id);
      if (found != source->models().end()) return &found->second;
    }
    return nullptr;
  }

  static std::string_view IdOf(const Document& document, const Element& element) {
    if (!CategoryFromTag(element.tag)) return element.tag;
    const Attribute* id = document.FindAttribute(element, "ID");
    return id && element.tag != "SubTree" ? std::string_view(id->value) : std::string_view();
  }

  // A port to which a literal is given anywhere cannot be written.
  static void AddAttributes(const Document& document, const Element& element, Ports& ports) {
    for (const Attribute* attribute = document.attributes_begin(element);
         attribute != document.attributes_end(element); ++attribute) {
      if (IsReservedAttribute(attribute->name)) continue;
      const bool is_key = !KeyOf(attribute->value, attribute->name).empty();
      auto port = std::find_if(ports.begin(), ports.end(),
                               [&](const auto& p) { return p.name == attribute->name; });
      if (port == ports.end()) {
        port = ports.insert(ports.end(), {std::string(attribute->name), PortDirection::kInOut,
                                          nullptr, "", false, std::nullopt});
      }
      if (!is_key) port->direction = PortDirection::kInput;
    }
  }

  const Project& project_;
  const Project* const models_;
  const Registry& known_;
  std::map<std::string, const NodeModel*> shipped_;
  std::map<std::string, Seen> leaves_;
};

}  // namespace

std::shared_ptr<const Registry> ScenarioRegistry(const Project& project, const Project* models,
                                                 std::shared_ptr<Registry> known) {
  if (!known) known = std::make_shared<Registry>();
  const Leaves leaves(project, models, *known);
  leaves.RegisterAll(*known);
  return known;
}

bool IsStandIn(const Registry::Entry& entry) {
  if (!entry.build) return false;
  const PortCollector unused;
  return dynamic_cast<const StandIn*>(entry.build().get()) != nullptr;
}

bool NeedsScript(const Registry::Entry& entry) {
  if (IsStandIn(entry)) return true;
  if (!entry.build) return false;
  const PortCollector unused;
  return dynamic_cast<const UnknownDecorator*>(entry.build().get()) != nullptr;
}

}  // namespace coppice
