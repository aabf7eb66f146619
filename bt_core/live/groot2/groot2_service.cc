#include "bt_core/live/groot2/groot2_service.h"

#include <exception>
#include <utility>

#include "bt_core/live/groot2/board_message.h"
#include "bt_core/live/groot2/full_tree.h"

namespace coppice {

using groot2::Parts;
using groot2::Request;
using groot2::RequestType;

namespace {

// The others change what other clients see: hooks, and the one recording that there is.
bool OnlyReads(RequestType type) {
  return type == RequestType::kFullTree || type == RequestType::kStatus ||
         type == RequestType::kBlackboard || type == RequestType::kDumpHooks;
}

}  // namespace

Groot2Service::Groot2Service(std::shared_ptr<LiveTree> tree, Duration deadline)
    : tree_(std::move(tree)), deadline_(deadline), hooks_(tree_->debugger(), tree_->kGroot2Owner) {}

Parts Groot2Service::Answer(const Request& request, bool may_control, Duration now) {
  const std::size_t nodes = tree_->program()->nodes.size();
  if (nodes > groot2::kMaxNodes) {
    return groot2::MakeError("the tree has " + std::to_string(nodes) +
                             " nodes; this protocol can number " +
                             std::to_string(groot2::kMaxNodes));
  }
  if (!may_control && !OnlyReads(request.type)) {
    return groot2::MakeError("this client may watch, not control: its token is for readers");
  }
  if (may_control) Heed(now);  // who may only watch brings no breakpoint of another back
  try {
    Expected<Payload> payload = OnlyReads(request.type) ? Serve(request) : Control(request);
    if (!payload) return groot2::MakeError(payload.problem());
    if (!*payload) return groot2::MakeReply(request, tree_->id());
    return groot2::MakeReply(request, tree_->id(), *std::move(*payload));
  } catch (const std::exception& error) {  // malformed JSON, text that is not UTF-8
    return groot2::MakeError(error.what());
  }
}

void Groot2Service::Heed(Duration now) {
  last_request_ = now;
  if (std::exchange(silenced_, false)) hooks_.SetAllEnabled(true);
}

void Groot2Service::Expire(Duration now) {
  if (silenced_ || hooks_.empty() || now - last_request_ < deadline_) return;
  silenced_ = true;
  hooks_.SetAllEnabled(false);
}

Expected<Groot2Service::Payload> Groot2Service::Done(const Outcome& outcome) {
  if (!outcome) return Problem{outcome.problem()};
  return Payload();
}

Expected<Groot2Service::Payload> Groot2Service::Serve(const Request& request) {
  switch (request.type) {
    case RequestType::kFullTree:
      return FullTree();
    case RequestType::kStatus:
      return Statuses();
    case RequestType::kBlackboard:
      return Boards(request.argument);
    case RequestType::kDumpHooks:
      return hooks_.Dump();
    default:
      return Problem{"Request not recognized"};
  }
}

Expected<Groot2Service::Payload> Groot2Service::Control(const Request& request) {
  switch (request.type) {
    case RequestType::kInsertHooks:
      return Done(hooks_.Insert(request.argument, tree_->program()->nodes.size()));
    case RequestType::kRemoveHook:
      return Done(hooks_.Remove(request.argument));
    case RequestType::kUnlock:
      return Done(hooks_.Unlock(request.argument));
    case RequestType::kRemoveAllHooks:
      hooks_.RemoveAll();
      return Payload();
    case RequestType::kToggleRecording:
      return ToggleRecording(request.argument);
    case RequestType::kTransitions:
      return tree_->TakeTransitions();
    case RequestType::kDisableAllHooks:
      hooks_.SetAllEnabled(false);
      return Payload();
    default:
      return Problem{"Request not recognized"};
  }
}

// Written once for each program: of 20 000 nodes that takes 30 ms.
Expected<Groot2Service::Payload> Groot2Service::FullTree() {
  const std::shared_ptr<const Program> program = tree_->program();
  if (program != written_program_) {
    full_tree_ = WriteFullTree(*program);
    written_program_ = program;
  }
  if (!full_tree_) {
    return Problem{"the text of this tree is longer than " +
                   std::to_string(kLongestFullTree >> 20) + " MiB with all its SubTrees"};
  }
  return Payload(full_tree_);
}

Groot2Service::Payload Groot2Service::ToggleRecording(std::string_view what) {
  if (what == "start") return std::to_string(tree_->StartRecording());
  if (what == "stop") tree_->StopRecording();
  return {};
}

std::string Groot2Service::Statuses() const {
  const OfProgram<std::uint8_t> statuses = tree_->ShownStatuses();
  std::string payload;
  payload.reserve(statuses.items.size() * 3);
  for (const NodeIndex node : NodesByInstance(*statuses.program)) {
    groot2::AppendStatus(payload, Uid(node), statuses.items[node]);
  }
  return payload;
}

std::string Groot2Service::Boards(std::string_view names) const {
  const OfProgram<std::string> values = tree_->Values();
  const Layout& layout = values.program->layout;
  return WriteBoards(layout, FindScopes(layout, groot2::SplitNames(names)), values.items);
}

Parts Groot2Service::Notification(const DebugEvent& event) {
  if (event.kind != DebugEvent::Kind::kStopped && event.kind != DebugEvent::Kind::kReplaced) {
    return {};
  }
  const std::optional<std::uint16_t> uid = hooks_.UidOf(event.stop.hook);
  if (!uid) return {};
  const char type = static_cast<char>(RequestType::kBreakpointReached);
  return {groot2::MakeHeader(type, ++notifications_), std::to_string(*uid)};
}

}  // namespace coppice
