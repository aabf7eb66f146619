#include "bt_core/engine/executor.h"

#include <exception>
#include <utility>

namespace coppice {

Executor::Executor(std::shared_ptr<const Program> program, Clock& clock, ExecutorOptions options)
    : program_(std::move(program)),
      nodes_(program_->nodes.data()),
      clock_(clock),
      inbox_(std::make_shared<Inbox>()),
      statuses_(program_->nodes.size(), Status::kIdle),
      memory_(program_->nodes.size(), 0),
      blackboard_(MakeBlackboard(program_->layout)),
      options_(options) {
  now_ = clock_.Now();
  users_.reserve(program_->leaves.size());
  for (const LeafRecord& record : program_->leaves) BuildUser(record);
}

Executor::~Executor() { Halt(); }

void Executor::BuildUser(const LeafRecord& record) {
  const Registry::Entry* entry = program_->info[record.node].entry;
  const PortCollector collector;
  std::unique_ptr<UserNode> node =
      entry ? entry->build() : program_->registry->fallback()(program_->Name(record.node));
  node->set_host(this);
  if (entry) {  // only the nodes of the registry have ports
    for (const PortCollector::Port& port : collector.ports) user_ports_.push_back(port.port);
  }
  users_.push_back({std::move(node), entry ? entry->tick : &Registry::TickVirtually});
  BindPorts(record);
}

// Of the user node that was added last.
void Executor::BindPorts(const LeafRecord& record) {
  const Registry::Entry* entry = program_->info[record.node].entry;
  const std::size_t count = entry ? entry->declarations.size() : 0;
  PortBase* const* ports = user_ports_.data() + user_ports_.size() - count;
  for (std::size_t k = 0; k < count; ++k) {
    const SlotIndex slot = program_->ports[record.first_port + k].slot;
    if (slot != kNoSlot) ports[k]->Bind(&blackboard_[slot], blackboard_.now(), slot, inbox_);
  }
  if (nodes_[record.node].type == NodeType::kUser) {
    GiveChildren(*users_.back().node, record.node);
  }
}

void Executor::GiveChildren(UserNode& node, NodeIndex index) {
  std::vector<NodeIndex> children;
  for (NodeIndex i = index + 1; i < nodes_[index].end; i = nodes_[i].end) children.push_back(i);
  static_cast<UserControl&>(node).set_children(Children(*this, std::move(children)));
}

Status Executor::Tick() {
  if (hooked_.hooks()) hooked_.hooks()->BeforeTick();
  now_ = clock_.Now();
  blackboard_.set_now(now_);
  wake_at_ = kNever;
  tick_again_ = false;
  ++ticks_;
  RunCalls();
  reporter_.BeginTick();
  if (!drains_.empty()) ServeDrains();
  if (inbox_->has_messages()) ApplyInbox();
  Status result;
  try {
    result = Tick(kRootNode);
  } catch (const Abort&) {
    result = EndAborted();
  }
  if (reporter_.is_listening()) reporter_.EndTick(ticks_, now_, result);
  if (thrown_) Rethrow();
  return result;
}

std::vector<Status> Executor::statuses() const {
  std::vector<Status> result = statuses_;
  for (NodeIndex i{1}; i < result.size(); ++i) {
    const NodeIndex parent = program_->info[i].parent;
    const bool behind =
        RunsOneChild(nodes_[parent].type) && i > static_cast<NodeIndex>(memory_[parent]);
    if (result[parent] != Status::kRunning || behind) result[i] = Status::kIdle;
  }
  return result;
}

Status Executor::StatusOf(NodeIndex node) const {
  if (node == kRootNode) return statuses_[node];
  const NodeIndex parent = program_->info[node].parent;
  const bool behind =
      RunsOneChild(nodes_[parent].type) && node > static_cast<NodeIndex>(memory_[parent]);
  return behind || StatusOf(parent) != Status::kRunning ? Status::kIdle : statuses_[node];
}

void Executor::RunCalls() {
  if (!inbox_->has_calls()) return;
  inbox_->TakeCalls(calls_);
  for (const Inbox::Call& call : calls_) call();
  calls_.clear();
}

void Executor::ApplyInbox() {
  inbox_->TakeMessages(delivery_);
  for (Inbox::Message& message : delivery_) {
    Slot& slot = blackboard_[message.slot];
    if (message.epoch < slot.epoch) continue;  // answer to a question that is no longer asked
    slot.value = std::move(message.value);
    slot.epoch = message.epoch;
    slot.CountWrite(now_);
    reporter_.Delivery(message.slot);
  }
  delivery_.clear();
}

void Executor::CheckType(SlotIndex slot, const Type& type) const {
  const SlotDefinition& definition = program_->layout.slots[slot];
  if (!definition.type || definition.type == &type) return;
  throw std::invalid_argument("key \"" + definition.key + "\" is " + definition.type->name +
                              " in the tree, not " + type.name);
}

}  // namespace coppice
