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

// The node is read from the shell each time, rather than kept meanwhile: that costs less.
template <class Shell>
[[gnu::always_inline]] inline Status TickShell(Shell& shell, bool starting) {
  TreeRun::Enter(*shell.filling.node, starting ? NodeStatus::IDLE : NodeStatus::RUNNING);
  NodeStatus result;
  try {
    result = TreeRun::TickEntered(*shell.filling.node);
  } catch (...) {
    TreeRun::Leave(*shell.filling.node);
    throw;
  }
  TreeRun::Leave(*shell.filling.node);
  return static_cast<Status>(result);
}

class LeafShell final : public coppice::Leaf {
 public:
  explicit LeafShell(const Declarations& declarations) : ports_(declarations) {}
  Status Tick(bool starting) override { return TickShell(*this, starting); }
  void Halt() override { filling.run->HaltNode(*filling.node); }

  Filling filling;

 private:
  ShellPorts ports_;
};

class ControlShell final : public coppice::UserControl {
 public:
  explicit ControlShell(const Declarations& declarations) : ports_(declarations) {}
  Status Tick(coppice::Children&, bool starting) override { return TickShell(*this, starting); }
  void OnHalted() override { filling.run->HaltNode(*filling.node); }

  Filling filling;

 private:
  ShellPorts ports_;
};

[[gnu::noinline]] Status IdleOrSkipped(LeafShell& shell, Status result) {
  if (result == Status::kIdle) throw std::logic_error("returned IDLE, which no node may");
  shell.host().KeepSkipped();
  return result;
}

// As Registry::TickVirtually, without its virtual call.
Status TickLeafShell(coppice::UserNode& node, Status before) {
  auto& shell = static_cast<LeafShell&>(node);
  bool starting = before != Status::kRunning;
  if (starting && shell.host().keeps_skipped_nodes()) starting = !shell.host().ResumeSkipped();
  const Status result = TickShell(shell, starting);
  if (result == Status::kIdle || result == Status::kSkipped) return IdleOrSkipped(shell, result);
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
