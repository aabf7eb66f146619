#include "bt_core/engine/executor.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "bt_core/nodes/decorator.h"

namespace coppice {

Executor::Executor(std::shared_ptr<const Program> program, Clock& clock)
    : program_(std::move(program)),
      nodes_(program_->nodes.data()),
      clock_(clock),
      inbox_(std::make_shared<Inbox>()),
      statuses_(program_->nodes.size(), Status::kIdle),
      memory_(program_->nodes.size(), 0),
      blackboard_(MakeBlackboard(program_->layout)) {
  now_ = clock_.Now();
  BuildLeaves();
}

Executor::~Executor() { Halt(); }

void Executor::BuildLeaves() {
  leaves_.reserve(program_->leaves.size());
  for (const LeafRecord& record : program_->leaves) {
    const Registry::Entry* entry = program_->info[record.node].entry;
    const PortCollector collector;
    std::unique_ptr<UserNode> leaf =
        entry ? entry->build() : program_->registry->fallback()(program_->Name(record.node));
    leaf->set_host(this);
    std::uint32_t next = record.first_port;
    for (const PortCollector::Port& port : collector.ports) {
      if (!entry) break;  // only the leaves of the registry have ports
      const SlotIndex slot = program_->ports[next++].slot;
      if (slot != kNoSlot) port.port->Bind(&blackboard_[slot], slot, inbox_);
    }
    leaves_.push_back(std::move(leaf));
  }
}

Status Executor::Tick() {
  now_ = clock_.Now();
  wake_at_ = kNever;
  tick_again_ = false;
  ++ticks_;
  RunCalls();
  if (inbox_->has_messages()) ApplyInbox();
  const Status result = Tick(0);
  if (listening_) Report(result);
  return result;
}

void Executor::Halt() {
  Halt(0);
  wake_at_ = kNever;
  tick_again_ = false;
  if (listening_ && !changes_.empty()) Report(Status::kIdle);
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
    ++slot.writes;
  }
  delivery_.clear();
}

inline Status Executor::Store(NodeIndex node, Status result) {
  if (result != statuses_[node]) SetStatus(node, result);
  return result;
}

inline Status Executor::StoreAndForget(NodeIndex node, Status result) {
  if (result != Status::kRunning) memory_[node] = 0;
  return Store(node, result);
}

Status Executor::TickInner(NodeIndex node, NodeType type) {
  switch (type) {
    case NodeType::kSequence:
      return StoreAndForget(node, TickSequence(*this, node));
    case NodeType::kFallback:
      return StoreAndForget(node, TickFallback(*this, node));
    case NodeType::kReactiveSequence:
      return Store(node, TickReactiveSequence(*this, node));
    case NodeType::kReactiveFallback:
      return Store(node, TickReactiveFallback(*this, node));
    case NodeType::kInverter:
      return Store(node, TickMapped(*this, node, Status::kFailure, Status::kSuccess));
    case NodeType::kForceSuccess:
      return Store(node, TickMapped(*this, node, Status::kSuccess, Status::kSuccess));
    case NodeType::kForceFailure:
      return Store(node, TickMapped(*this, node, Status::kFailure, Status::kFailure));
    case NodeType::kSubTree:
      return Store(node, TickMapped(*this, node, Status::kSuccess, Status::kFailure));
    case NodeType::kAlwaysSuccess:
      return Store(node, Status::kSuccess);
    case NodeType::kAlwaysFailure:
      return Store(node, Status::kFailure);
    default:
      return StoreAndForget(node, TickOthers(node, type));
  }
}

Status Executor::TickOthers(NodeIndex node, NodeType type) {
  try {
    return DispatchOthers(node, type);
  } catch (...) {
    ResetChildren(node);
    return FailByException(node);
  }
}

Status Executor::TickLeaf(NodeIndex node) {
  current_leaf_ = node;
  Status result;
  try {
    result = leaves_[nodes_[node].first_port]->Tick(statuses_[node] != Status::kRunning);
    if (result == Status::kIdle) result = RefuseIdle();
  } catch (...) {
    result = FailByException(node);
  }
  return Store(node, result);
}

Status Executor::RefuseIdle() {
  AddMessage("returned IDLE, which no node may; taken as FAILURE");
  return Status::kFailure;
}

// Called while an exception is being handled.
Status Executor::FailByException(NodeIndex node) {
  current_leaf_ = node;
  try {
    throw;
  } catch (const UnsetInput& error) {
    AddMessage(Describe(error, node));
  } catch (const std::exception& error) {
    AddMessage(error.what());
  } catch (...) {
    AddMessage("threw something that is not a std::exception");
  }
  return Status::kFailure;
}

// Only what runs has descendants that are not idle.
void Executor::HaltRunning(NodeIndex node) {
  for (NodeIndex i = node; i < nodes_[node].end;) {
    const bool running = statuses_[i] == Status::kRunning;
    if (running && nodes_[i].type == NodeType::kLeaf) HaltLeaf(i);
    memory_[i] = 0;
    if (statuses_[i] != Status::kIdle) SetStatus(i, Status::kIdle);
    i = running ? i + 1 : nodes_[i].end;
  }
}

void Executor::ResetChildren(NodeIndex node) {
  const NodeIndex end = nodes_[node].end;
  for (NodeIndex child = node + 1; child != end; child = nodes_[child].end) Halt(child);
}

void Executor::HaltLeaf(NodeIndex node) {
  current_leaf_ = node;
  try {
    leaves_[nodes_[node].first_port]->Halt();
  } catch (const std::exception& error) {
    AddMessage(std::string("while halting: ") + error.what());
  } catch (...) {
    AddMessage("while halting: threw something that is not a std::exception");
  }
}

// Which port it was is found only now, so that reading one costs nothing more.
std::string Executor::Describe(const UnsetInput& error, NodeIndex node) const {
  const Registry::Entry* entry = program_->info[node].entry;
  if (!error.slot || !entry) return error.what();
  const auto slot = static_cast<SlotIndex>(error.slot - blackboard_.data());
  const NodeRecord& record = nodes_[node];
  const std::uint32_t first = record.type == NodeType::kLeaf
                                  ? program_->leaves[record.first_port].first_port
                                  : record.first_port;
  for (std::size_t k = 0; k < entry->declarations.size(); ++k) {
    if (program_->ports[first + k].slot != slot) continue;
    return "input \"" + entry->declarations[k].name + "\" has no value: nobody has written key \"" +
           program_->layout.slots[slot].key + "\" yet";
  }
  return error.what();
}

void Executor::RecordChange(NodeIndex node, Status status) {
  changes_.push_back({node, statuses_[node], status});
}

void Executor::AddMessage(std::string text) {
  if (listening_) messages_.push_back({current_leaf_, std::move(text)});
}

void Executor::Drain(Duration) {}

void Executor::AddSink(TickSink* sink) {
  sinks_.push_back(sink);
  listening_ = true;
  reported_writes_.resize(blackboard_.size(), 0);
}

void Executor::RemoveSink(TickSink* sink) {
  sinks_.erase(std::remove(sinks_.begin(), sinks_.end(), sink), sinks_.end());
  listening_ = !sinks_.empty();
}

void Executor::Report(Status result) {
  writes_.clear();
  for (SlotIndex i = 0; i < blackboard_.size(); ++i) {
    if (blackboard_[i].writes == reported_writes_[i]) continue;
    reported_writes_[i] = blackboard_[i].writes;
    writes_.push_back(i);
  }
  const TickEvents events{ticks_, now_, result, changes_, writes_, messages_, blackboard_};
  for (TickSink* sink : sinks_) sink->OnTick(events);
  changes_.clear();
  messages_.clear();
}

void Executor::CheckType(SlotIndex slot, const Type& type) const {
  const SlotDefinition& definition = program_->layout.slots[slot];
  if (definition.type == &type) return;
  throw std::invalid_argument("key \"" + definition.key + "\" is " + definition.type->name +
                              " in the tree, not " + type.name);
}

}  // namespace coppice
