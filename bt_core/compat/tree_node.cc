#include "behaviortree_cpp/tree_node.h"

#include <algorithm>
#include <thread>

#include "behaviortree_cpp/control_node.h"
#include "behaviortree_cpp/decorator_node.h"
#include "bt_core/compat/tree_run.h"

namespace BT {

using internal::GateLock;
using internal::NodeCallbacks;

template <>
std::string toStr<PostCond>(const PostCond& condition) {
  return PostCondNames.at(static_cast<std::size_t>(condition));
}
template <>
std::string toStr<PreCond>(const PreCond& condition) {
  return PreCondNames.at(static_cast<std::size_t>(condition));
}

namespace {

internal::Gate& NoGate() {
  static internal::Gate gate;
  return gate;
}

void Delete(NodeCallbacks* callbacks) { delete callbacks; }

}  // namespace

TreeNode::TreeNode(std::string name, NodeConfig config)
    : name_(std::move(name)),
      config_(std::move(config)),
      gate_(&NoGate()),
      callbacks_(nullptr, &Delete) {}

TreeNode::~TreeNode() = default;

// ---- Ticks.

NodeStatus TreeNode::executeTick() { return TickAsItself(); }

NodeStatus TreeNode::TickThroughEngine() {
  if (run_) return run_->TickChild(*this);
  throw LogicError("node [", name_, "] is in no tree: BehaviorTreeFactory::createTree makes one");
}

NodeStatus TreeNode::TickWithScripts() {
  const Expected<NodeStatus> decided = AskPreScripts(status());
  const NodeStatus result = decided ? *decided : executeTick();
  RunPostScripts(result);
  return result;
}

void TreeNode::FindScripts() {
  const auto is_set = [](const ScriptFunction& script) { return script != nullptr; };
  has_scripts_ = std::any_of(pre_scripts_.begin(), pre_scripts_.end(), is_set) ||
                 std::any_of(post_scripts_.begin(), post_scripts_.end(), is_set);
}

// The result without a tick; an error if the node is to be ticked.
Expected<NodeStatus> TreeNode::AskPreScripts(NodeStatus before) {
  Ast::Environment environment{config_.blackboard, config_.enums};
  const auto test = [&](PreCond condition, bool otherwise) {
    const ScriptFunction& script = pre_scripts_[static_cast<std::size_t>(condition)];
    return script ? script(environment).cast<bool>() : otherwise;
  };
  const bool runs = before == NodeStatus::RUNNING;
  if (!runs) {
    if (test(PreCond::FAILURE_IF, false)) return NodeStatus::FAILURE;
    if (test(PreCond::SUCCESS_IF, false)) return NodeStatus::SUCCESS;
    if (test(PreCond::SKIP_IF, false)) return NodeStatus::SKIPPED;
  }
  if (test(PreCond::WHILE_TRUE, true)) return nonstd::make_unexpected("ticked");
  if (runs) {
    halt();
    RunPostScript(PostCond::ON_HALTED);
  }
  return NodeStatus::SKIPPED;
}

void TreeNode::RunPostScript(PostCond condition) {
  const ScriptFunction& script = post_scripts_[static_cast<std::size_t>(condition)];
  if (!script) return;
  Ast::Environment environment{config_.blackboard, config_.enums};
  script(environment);
}

void TreeNode::RunPostScripts(NodeStatus result) {
  if (!isStatusCompleted(result)) return;
  RunPostScript(result == NodeStatus::SUCCESS ? PostCond::ON_SUCCESS : PostCond::ON_FAILURE);
  RunPostScript(PostCond::ALWAYS);
}

void TreeNode::HaltForEngine() {
  struct Call {
    explicit Call(TreeNode& halted) : node(halted) {
      internal::TreeRun::Enter(node, NodeStatus::RUNNING);
    }
    ~Call() { internal::TreeRun::Leave(node); }
    TreeNode& node;
  };
  const Call call(*this);
  halt();
  if (has_scripts_) RunPostScript(PostCond::ON_HALTED);
}

void TreeNode::haltNode() {
  if (run_) run_->HaltChild(*this);
}

NodeStatus TreeNode::StatusInTree() const {
  return run_ ? run_->StatusOf(*this) : NodeStatus::IDLE;
}

// Outside of its tick the status of a node is what the engine says.
void TreeNode::setStatus(NodeStatus new_status) {
  if (new_status == NodeStatus::IDLE) {
    throw RuntimeError("Node [", name_,
                       "]: you are not allowed to set manually the status to IDLE. If you know "
                       "what you are doing (?) use resetStatus() instead.");
  }
  if (!IsEngineCalling()) return;
  own_status_.store(new_status, std::memory_order_relaxed);
  run_->OwnStatusSet(*this, new_status);
}

void TreeNode::resetStatus() {
  if (IsEngineCalling()) {
    own_status_.store(NodeStatus::IDLE, std::memory_order_relaxed);
  } else if (run_) {
    run_->HaltChild(*this);
  }
}

NodeStatus TreeNode::waitValidStatus() {
  while (isHalted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return status();
}

void TreeNode::emitWakeUpSignal() {
  if (run_) run_->wake_up()->emitSignal();
}

// ---- Those who watch.

namespace {
NodeCallbacks& Make(std::unique_ptr<NodeCallbacks, void (*)(NodeCallbacks*)>& callbacks) {
  if (!callbacks) callbacks.reset(new NodeCallbacks());
  return *callbacks;
}
}  // namespace

TreeNode::StatusChangeSubscriber TreeNode::subscribeToStatusChange(StatusChangeCallback callback) {
  auto subscriber = Make(callbacks_).changes.subscribe(std::move(callback));
  if (run_) run_->CallsChanged();
  return subscriber;
}
Signal<>::Subscriber TreeNode::SubscribeToTickEnd(std::function<void()> callback) {
  return run_ ? run_->tick_ended().subscribe(std::move(callback)) : nullptr;
}
void TreeNode::setPreTickFunction(PreTickCallback callback) {
  Make(callbacks_).pre = std::move(callback);
  if (run_) run_->CallsChanged();
}
void TreeNode::setPostTickFunction(PostTickCallback callback) {
  Make(callbacks_).post = std::move(callback);
  if (run_) run_->CallsChanged();
}
void TreeNode::setTickMonitorCallback(TickMonitorCallback callback) {
  Make(callbacks_).monitor = std::move(callback);
  if (run_) run_->CallsChanged();
}

// ---- Ports.

bool TreeNode::isBlackboardPointer(StringView text, StringView* stripped_pointer) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == StringView::npos) return false;
  text = text.substr(first, text.find_last_not_of(' ') - first + 1);
  if (text.size() < 3 || text.front() != '{' || text.back() != '}') return false;
  if (stripped_pointer) *stripped_pointer = text.substr(1, text.size() - 2);
  return true;
}

StringView TreeNode::stripBlackboardPointer(StringView text) {
  StringView key;
  return isBlackboardPointer(text, &key) ? key : StringView();
}

Expected<StringView> TreeNode::getRemappedKey(StringView port_name, StringView remapped_port) {
  if (remapped_port == "{=}" || remapped_port == "=") return port_name;
  StringView key;
  if (isBlackboardPointer(remapped_port, &key)) return key;
  return nonstd::make_unexpected("Not a blackboard pointer");
}

StringView TreeNode::getRawPortValue(const std::string& key) const {
  for (const PortsRemapping* ports : {&config_.input_ports, &config_.output_ports}) {
    const auto found = ports->find(key);
    if (found != ports->end()) return found->second;
  }
  return {};
}

void TreeNode::modifyPortsRemapping(const PortsRemapping& new_remapping) {
  for (const auto& [name, text] : new_remapping) {
    for (PortsRemapping* ports : {&config_.input_ports, &config_.output_ports}) {
      const auto found = ports->find(name);
      if (found != ports->end()) found->second = text;
    }
  }
  ports_.Clear();  // looked up by name from now on
}

TreeNode::Source TreeNode::SourceOf(const std::string& key) const {
  Source source;
  if (config_.manifest) {
    const auto port = config_.manifest->ports.find(key);
    if (port != config_.manifest->ports.end()) source.info = &port->second;
  }
  const auto given = config_.input_ports.find(key);
  if (given != config_.input_ports.end()) {
    source.text = given->second;
  } else if (!source.info) {
    source.error = StrCat("getInput() of node '", fullPath(), "': it has no input port [", key,
                          "]; is it in providedPorts()?");
  } else if (source.info->defaultValue().empty()) {
    source.error = StrCat("getInput() of node '", fullPath(), "': the XML does not give the port [",
                          key, "], and it has no default");
  } else if (source.info->defaultValue().isString()) {
    source.text = source.info->defaultValue().cast<std::string>();
  } else {
    source.default_value = source.info->defaultValue();
  }
  if (!source.error.empty() || !source.default_value.empty()) return source;
  const auto name = getRemappedKey(key, source.text);
  if (!name) return source;
  source.text = std::string(*name);
  if (!config_.blackboard) {
    source.error = "getInput(): trying to access an invalid Blackboard";
  } else if (!(source.cell = config_.blackboard->FindCell(source.text))) {
    source.error = StrCat("getInput() failed because it was unable to find the key [", key,
                          "] remapped to [", source.text, "]");
  }
  return source;
}

Any TreeNode::ValueOf(const internal::Cell& cell, Timestamp& stamp) {
  const GateLock lock(*cell.gate);
  Any value;
  value.value() = cell.slot->value;
  stamp = {cell.slot->writes, cell.slot->stamp.time_since_epoch()};
  return value;
}

std::shared_ptr<internal::Cell> TreeNode::CellOfOutput(StringView key, std::string& error) const {
  if (!config_.blackboard) {
    error = "setOutput() failed: trying to access a Blackboard(BB) entry, but BB is invalid";
    return nullptr;
  }
  const auto given = config_.output_ports.find(std::string(key));
  if (given == config_.output_ports.end()) {
    error = StrCat("setOutput() failed: NodeConfig::output_ports does not contain the key: [", key,
                   "]");
    return nullptr;
  }
  const auto name = getRemappedKey(key, given->second);
  if (!name) {
    error = "setOutput requires a blackboard pointer. Use {}";
    return nullptr;
  }
  auto cell = config_.blackboard->FindCell(*name);
  return cell ? cell : config_.blackboard->MakeCell(*name);
}

AnyPtrLocked TreeNode::getLockedPortContent(const std::string& key) {
  const auto name = getRemappedKey(key, getRawPortValue(key));
  if (!name || !config_.blackboard) return {};
  const std::string remapped(*name);
  if (!config_.blackboard->FindCell(remapped)) {
    TypeInfo info;
    if (config_.manifest) {
      const auto port = config_.manifest->ports.find(key);
      if (port != config_.manifest->ports.end()) info = port->second;
    }
    config_.blackboard->createEntry(remapped, info);
  }
  return config_.blackboard->getAnyLocked(remapped);
}

// ---- Nodes with children.

void ControlNode::halt() { resetChildren(); }
void ControlNode::haltChildren() { resetChildren(); }
void ControlNode::haltChildren(std::size_t first) {
  for (std::size_t k = first; k < children_nodes_.size(); ++k) haltChild(k);
}
void ControlNode::haltChild(std::size_t index) { children_nodes_.at(index)->haltNode(); }
void ControlNode::resetChildren() {
  for (TreeNode* child : children_nodes_) child->haltNode();
}

void DecoratorNode::setChild(TreeNode* child) {
  if (child_node_) {
    throw BehaviorTreeException("Decorator [", name(), "] has already a child assigned");
  }
  child_node_ = child;
}
void DecoratorNode::halt() { resetChild(); }
void DecoratorNode::resetChild() {
  if (child_node_) child_node_->haltNode();
}
NodeStatus DecoratorNode::executeTick() {
  const bool engine_calls = IsEngineCalling();
  const NodeStatus status = TreeNode::executeTick();
  if (engine_calls && child_node_ && isStatusCompleted(child_node_->status())) resetChild();
  return status;
}

}  // namespace BT
