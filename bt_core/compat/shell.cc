#include "bt_core/compat/shell.h"

#include <cstdint>
#include <stdexcept>
#include <utility>

namespace BT::internal {
namespace {

using coppice::Status;

// Only so that the program has a place for the port; the node itself reads and writes there.
class ShellPort final : public coppice::PortBase {
 public:
  explicit ShellPort(const coppice::PortDeclaration& declaration) : PortBase(declaration) {}
};

struct Filling {
  TreeNode* node = nullptr;
  TreeRun* run = nullptr;
};

class ShellPorts {
 public:
  explicit ShellPorts(const Declarations& declarations) {
    if (!declarations) return;
    for (const coppice::PortDeclaration& declaration : *declarations) {
      ports_.emplace_back(declaration);
    }
  }

 private:
  std::deque<ShellPort> ports_;
};

Status TickFilling(const Filling& filling, bool starting) {
  const NodeStatus before = starting ? NodeStatus::IDLE : NodeStatus::RUNNING;
  return static_cast<Status>(TreeRun::TickNode(*filling.node, before));
}

class LeafShell final : public coppice::Leaf {
 public:
  explicit LeafShell(const Declarations& declarations) : ports_(declarations) {}
  Status Tick(bool starting) override { return TickFilling(filling, starting); }
  void Halt() override { filling.run->HaltNode(*filling.node); }

  Filling filling;

 private:
  ShellPorts ports_;
};

class ControlShell final : public coppice::UserControl {
 public:
  explicit ControlShell(const Declarations& declarations) : ports_(declarations) {}
  Status Tick(coppice::Children&, bool starting) override { return TickFilling(filling, starting); }
  void OnHalted() override { filling.run->HaltNode(*filling.node); }

  Filling filling;

 private:
  ShellPorts ports_;
};

// As Registry::TickVirtually, without its virtual call.
Status TickLeafShell(coppice::UserNode& node, Status before) {
  auto& shell = static_cast<LeafShell&>(node);
  bool starting = before != Status::kRunning;
  if (starting && node.host().keeps_skipped_nodes()) starting = !node.host().ResumeSkipped();
  const Status result = shell.Tick(starting);
  if (result == Status::kIdle) throw std::logic_error("returned IDLE, which no node may");
  if (result == Status::kSkipped) node.host().KeepSkipped();
  return result;
}

coppice::PortDirection DirectionOf(PortDirection direction) {
  switch (direction) {
    case PortDirection::INPUT:
      return coppice::PortDirection::kInput;
    case PortDirection::OUTPUT:
      return coppice::PortDirection::kOutput;
    case PortDirection::INOUT:
      break;
  }
  return coppice::PortDirection::kInOut;
}

}  // namespace

Declarations DeclarationsOf(const PortsList& ports) {
  auto declarations = std::make_shared<std::vector<coppice::PortDeclaration>>();
  for (const auto& [name, port] : ports) {
    coppice::PortDeclaration declaration;
    declaration.name = name;
    declaration.direction = DirectionOf(port.direction());
    declaration.description = port.description();
    declaration.required = false;
    const std::string& text = port.defaultValueString();
    const bool is_output = port.direction() == PortDirection::OUTPUT;
    if (!text.empty() && (!is_output || TreeNode::isBlackboardPointer(text))) {
      declaration.default_text = text;
    }
    declaration.converts = true;
    declarations->push_back(std::move(declaration));
  }
  return declarations;
}

coppice::NodeCategory CategoryOf(NodeType type) {
  switch (type) {
    case NodeType::CONDITION:
      return coppice::NodeCategory::kCondition;
    case NodeType::CONTROL:
      return coppice::NodeCategory::kControl;
    case NodeType::DECORATOR:
      return coppice::NodeCategory::kDecorator;
    case NodeType::SUBTREE:
      return coppice::NodeCategory::kSubTree;
    case NodeType::ACTION:
    case NodeType::UNDEFINED:
      break;
  }
  return coppice::NodeCategory::kAction;
}

void AddShells(coppice::Registry& registry, const TreeNodeManifest& manifest) {
  const coppice::Manifest described{manifest.registration_ID, CategoryOf(manifest.type), "", {}};
  const Declarations declarations = DeclarationsOf(manifest.ports);
  if (manifest.type == NodeType::CONTROL || manifest.type == NodeType::DECORATOR) {
    const std::uint32_t most = manifest.type == NodeType::CONTROL ? UINT32_MAX : 1;
    registry.AddBuilder(described, {1, most},
                        [declarations] { return std::make_unique<ControlShell>(declarations); });
  } else {
    registry.AddBuilder(
        described, {0, 0}, [declarations] { return std::make_unique<LeafShell>(declarations); },
        &TickLeafShell);
  }
}

std::unique_ptr<coppice::UserNode> MakeBareShell() { return std::make_unique<LeafShell>(nullptr); }
coppice::Registry::TickFunction ShellTick() { return &TickLeafShell; }

void Fill(coppice::UserNode& shell, TreeNode& node, TreeRun& run) {
  if (auto* const leaf = dynamic_cast<LeafShell*>(&shell)) {
    leaf->filling = {&node, &run};
  } else {
    dynamic_cast<ControlShell&>(shell).filling = {&node, &run};
  }
}

}  // namespace BT::internal
