#include "bt_core/live/groot2/client_groot2.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <memory>
#include <utility>

namespace coppice {
namespace {

constexpr Duration kPatience = std::chrono::milliseconds(2000);
constexpr std::size_t kMaxAnswer = 16 << 20;  // bytes: read, it takes many times of that
constexpr char kVersion = 2;
constexpr std::size_t kMaxHookPaths = 4 << 20;  // bytes, of the breakpoints of others
constexpr std::size_t kRequestHeader = 6;
constexpr std::size_t kReplyHeader = 22;

constexpr char kFullTree = 'T';
constexpr char kStatus = 'S';
constexpr char kBlackboard = 'B';
constexpr char kHookInsert = 'I';
constexpr char kHookRemove = 'R';
constexpr char kHooksDump = 'D';
constexpr char kUnlock = 'U';
constexpr char kRecording = 'r';
constexpr char kTransitions = 't';
constexpr char kNotification = 'N';

std::string Header(char type, std::uint32_t number) {
  std::string header = {kVersion, type};
  for (int shift = 0; shift < 32; shift += 8) header += static_cast<char>(number >> shift);
  return header;
}

// The clock of a Groot2 robot counts from 1970.
Time RobotTime() { return Time(std::chrono::system_clock::now().time_since_epoch()); }

void Reply(const LiveClient::ReplyHandler& on_reply, const LiveReply& reply) {
  if (on_reply) on_reply(reply);
}

LiveReply ReplyOf(const Expected<std::string>& answer, HookId hook = kNoHook) {
  if (!answer) return Problem{answer.problem()};
  return HookAnswer{hook, {}};
}

}  // namespace

ClientGroot2::ClientGroot2(const LiveClientOptions& options, LiveListener& listener,
                           Groot2History& history, Sender sender)
    : options_(options), listener_(listener), history_(history), sender_(std::move(sender)) {
  Greet();
}

// A status says which tree it is of. If it is the known one, it goes on.
void ClientGroot2::Greet() {
  Ask(kStatus, "", [this](const Answer& answer) {
    if (!answer.payload) return Fail("the robot answers: " + answer.payload.problem());
    if (history_.has_begun() && history_.id() == id_) return BeginLive();
    AskForTree();
  });
}

void ClientGroot2::AskForTree() {
  is_live_ = false;
  Ask(kFullTree, "", [this](const Answer& answer) {
    if (!answer.payload) return Fail("the robot answers: " + answer.payload.problem());
    Check(history_.SetTree(id_, *answer.payload));
    if (failure().empty()) AskForStart();
  });
}

void ClientGroot2::AskForStart() {
  AskForBoards();
  AskForHooks();
  Ask(kRecording, "start", [this](const Answer& answer) {
    if (answer.payload) Check(history_.SetRecording(*answer.payload));
  });
  Ask(kStatus, "", [this](const Answer& answer) {
    if (!answer.payload) return Fail("the robot answers: " + answer.payload.problem());
    Check(history_.AddStatuses(*answer.payload, RobotTime()));
    if (failure().empty()) BeginLive();
  });
}

void ClientGroot2::BeginLive() {
  is_live_ = true;
  LiveConnection connection;
  connection.is_live = true;
  connection.protocol = LiveConnection::Protocol::kGroot2;
  connection.trees = {history_.tree().description.main_tree};
  connection.run = history_.id();
  listener_.OnConnection(connection);
}

void ClientGroot2::AskForBoards() {
  std::string names;
  for (const std::string& board : history_.tree().boards) {
    names += (names.empty() ? "" : ";") + board;
  }
  Ask(kBlackboard, std::move(names), [this](const Answer& answer) {
    if (answer.payload) Check(history_.AddBoards(*answer.payload, RobotTime()));
  });
}

void ClientGroot2::AskForHooks() {
  Ask(kHooksDump, "", [this](const Answer& answer) {
    if (answer.payload) TakeHooks(groot2::ReadHooks(*answer.payload));
  });
}

// What this client has not set is of others; one that was there before keeps its number.
void ClientGroot2::TakeHooks(const std::vector<groot2::ListedHook>& listed) {
  const auto others = std::stable_partition(
      hooks_.begin(), hooks_.end(), [](const KnownHook& known) { return !known.is_foreign; });
  const std::vector<KnownHook> before(others, hooks_.end());
  hooks_.erase(others, hooks_.end());
  const auto find = [](const std::vector<KnownHook>& hooks, const groot2::ListedHook& hook) {
    return std::find_if(hooks.begin(), hooks.end(), [&](const KnownHook& known) {
      return known.IsAt(hook.uid, hook.hook.position);
    });
  };
  std::size_t path_bytes = 0;
  for (const groot2::ListedHook& there : listed) {
    const NodeIndex node = history_.tree().Find(there.uid);
    if (node == kNoNode || find(hooks_, there) != hooks_.end()) continue;
    path_bytes += history_.tree().description.nodes[node].path.size();
    if (path_bytes > kMaxHookPaths) break;
    const auto known = find(before, there);
    hooks_.push_back(known != before.end() ? *known : KnownHook{++last_hook_, there.uid, {}, true});
    hooks_.back().hook = there.hook;
    hooks_.back().hook.path = history_.tree().description.nodes[node].path;
  }
  TellForeignHooks();
}

void ClientGroot2::TellForeignHooks() {
  std::vector<ForeignHook> foreign;
  std::string text;
  for (const KnownHook& known : hooks_) {
    if (!known.is_foreign) continue;
    foreign.push_back({known.id, known.hook});
    text += known.hook.path + std::to_string(known.id) + ToString(known.hook) +
            (known.hook.enabled ? "+" : "-");
  }
  if (std::exchange(told_hooks_, text) != text) listener_.OnForeignHooks(foreign);
}

void ClientGroot2::Poll(Duration now) {
  next_poll_ = now + options_.poll_period;
  Ask(kTransitions, "", [this](const Answer& answer) {
    if (answer.payload) Check(history_.AddTransitions(*answer.payload));
  });
  Ask(kStatus, "", [this](const Answer& answer) {
    if (!answer.payload) return Fail("the robot answers: " + answer.payload.problem());
    Check(history_.AddStatuses(*answer.payload, RobotTime()));
  });
  if (now < next_boards_) return;
  next_boards_ = now + options_.board_period;
  AskForBoards();
  AskForHooks();
}

void ClientGroot2::Check(const Outcome& outcome) {
  if (!outcome) Fail(outcome.problem());
}

Duration ClientGroot2::OnTime(Duration now) {
  if (is_waiting_ && heard_ && now >= asked_ + kPatience) Fail("the robot does not answer");
  if (is_live_ && requests_.empty() && now >= next_poll_) Poll(now);
  SendNext(now);
  return is_waiting_ ? asked_ + kPatience : next_poll_;
}

void ClientGroot2::Ask(char type, std::string body, std::function<void(const Answer&)> on_answer) {
  requests_.push_back({type, std::move(body), std::move(on_answer)});
}

void ClientGroot2::SendNext(Duration now) {
  if (is_waiting_ || requests_.empty()) return;
  const Request& request = requests_.front();
  Parts parts = {Header(request.type, ++number_)};
  if (!request.body.empty()) parts.push_back(request.body);
  is_waiting_ = true;
  asked_ = now;
  sender_(parts);
}

void ClientGroot2::OnMessage(const Parts& parts, Duration now) {
  if (parts.size() > 1 && parts[1].size() > kMaxAnswer) {
    return Fail("the robot sent an answer that is too large");
  }
  if (parts[0].size() == kRequestHeader && parts[0][1] == kNotification && parts.size() > 1) {
    return OnNotification(parts[1]);
  }
  if (!is_waiting_) return;
  const bool is_error = parts.size() == 2 && parts[0] == "error";
  const char type = requests_.front().type;
  if (!is_error && (parts[0].size() != kReplyHeader ||
                    parts[0].compare(0, kRequestHeader, Header(type, number_)) != 0)) {
    return FailForProtocol();
  }
  heard_ = true;
  is_waiting_ = false;
  if (!is_error) std::copy_n(parts[0].begin() + kRequestHeader, id_.size(), id_.begin());
  if (is_live_ && id_ != history_.id()) {
    Abandon("the robot runs another tree");
    return AskForTree();
  }
  const Request request = std::move(requests_.front());
  requests_.pop_front();
  const std::string text = parts.size() > 1 ? parts[1] : std::string();
  request.on_answer({is_error ? Expected<std::string>(Problem{text}) : text});
  SendNext(now);
}

void ClientGroot2::Abandon(const std::string& why) {
  for (const Request& request : std::exchange(requests_, {})) {
    const bool is_command =
        request.type == kHookInsert || request.type == kHookRemove || request.type == kUnlock;
    if (is_command) request.on_answer({Problem{why}, false});
  }
}

// The protocol knows no clients: what is left in the robot would hold it up for everybody. Nobody
// waits for the answers.
void ClientGroot2::Leave() {
  for (const KnownHook& set : hooks_) {
    if (set.is_foreign) continue;
    sender_({Header(kHookRemove, ++number_), groot2::WriteHookRemove(set.uid, set.hook.position)});
  }
  hooks_.clear();
}

void ClientGroot2::Forget(HookId id) {
  hooks_.erase(std::remove_if(hooks_.begin(), hooks_.end(),
                              [id](const KnownHook& set) { return set.id == id; }),
               hooks_.end());
}

void ClientGroot2::OnNotification(const std::string& text) {
  std::uint16_t uid = 0;
  std::from_chars(text.data(), text.data() + text.size(), uid);
  const NodeIndex node = history_.tree().Find(uid);
  if (!is_live_ || node == kNoNode) return;
  LiveNotice notice;
  notice.path = history_.tree().description.nodes[node].path;
  notice.event.stop = {DebugStop::Where::kBefore, node};
  for (KnownHook& set : hooks_) {
    if (set.uid != uid) continue;
    notice.event.stop.hook = set.id;
    if (set.hook.position == HookPosition::kAfter) {
      notice.event.stop.where = DebugStop::Where::kAfter;
    }
    if (set.hook.action == HookAction::kReplace) {
      notice.event.kind = DebugEvent::Kind::kReplaced;
      notice.event.stop.result = set.hook.status;
    } else {
      set.stands = true;
    }
  }
  listener_.OnNotice(notice);
}

void ClientGroot2::Send(const LiveCommand& command, LiveClient::ReplyHandler on_reply) {
  switch (command.kind) {
    case LiveCommand::Kind::kAddHook:
      return AddHook(command.hook, std::move(on_reply));
    case LiveCommand::Kind::kRemoveHook:
      return RemoveHooks(command.id, on_reply);
    case LiveCommand::Kind::kContinue:
      return Continue(command.result, on_reply);
    case LiveCommand::Kind::kWrite:
      return Reply(on_reply,
                   Problem{"this robot knows the Groot2 protocol only; values cannot be set"});
    default:
      return Reply(on_reply,
                   Problem{"this robot knows the Groot2 protocol only; it stops at breakpoints, it "
                           "cannot pause or step"});
  }
}

void ClientGroot2::AddHook(const Hook& hook, LiveClient::ReplyHandler on_reply) {
  const Outcome checked = groot2::CheckHook(hook);
  if (!checked) return Reply(on_reply, Problem{checked.problem()});
  const RobotTree& tree = history_.tree();
  std::vector<NodeIndex> nodes = {hook.node};
  if (!hook.path.empty()) nodes = groot2::FindNodes(tree.description, hook.path);
  if (nodes.size() != 1 || nodes[0] >= tree.uids.size()) {
    const char* const what =
        nodes.size() > 1 ? "several nodes are called \"" : "no node is called \"";
    return Reply(on_reply, Problem{what + hook.path + "\""});
  }
  const std::uint16_t uid = tree.uids[nodes[0]];
  const KnownHook set = {++last_hook_, uid, hook, false};
  hooks_.push_back(set);
  Ask(kHookInsert, groot2::WriteHookInsert(hook, uid), [this, set, on_reply](const Answer& answer) {
    if (answer.is_of_robot && !answer.payload) Forget(set.id);
    Reply(on_reply, ReplyOf(answer.payload, set.id));
  });
}

void ClientGroot2::RemoveHooks(HookId id, const LiveClient::ReplyHandler& on_reply) {
  const auto is_meant = [id](const KnownHook& set) {
    return id == kNoHook ? !set.is_foreign : set.id == id;
  };
  const auto count = std::count_if(hooks_.begin(), hooks_.end(), is_meant);
  if (count == 0 && id == kNoHook) return Reply(on_reply, HookAnswer{});
  if (count == 0) {
    return Reply(on_reply, Problem{"there is no hook " + std::to_string(id)});
  }
  auto left = std::make_shared<std::ptrdiff_t>(count);
  for (const KnownHook& set : hooks_) {
    if (!is_meant(set)) continue;
    Ask(kHookRemove, groot2::WriteHookRemove(set.uid, set.hook.position),
        [left, on_reply](const Answer& answer) {
          if (--*left == 0) Reply(on_reply, ReplyOf(answer.payload));
        });
  }
  hooks_.erase(std::remove_if(hooks_.begin(), hooks_.end(), is_meant), hooks_.end());
  TellForeignHooks();
}

// Nobody says where a tree has stopped before this client was there: then it can only be a
// breakpoint of others.
void ClientGroot2::Continue(std::optional<Status> result,
                            const LiveClient::ReplyHandler& on_reply) {
  const bool is_known = std::any_of(hooks_.begin(), hooks_.end(),
                                    [](const KnownHook& known) { return known.stands; });
  const auto is_meant = [is_known](const KnownHook& known) {
    if (is_known) return known.stands;
    return known.is_foreign && known.hook.enabled && known.hook.action == HookAction::kStop;
  };
  auto left =
      std::make_shared<std::ptrdiff_t>(std::count_if(hooks_.begin(), hooks_.end(), is_meant));
  if (*left == 0) {
    return Reply(on_reply, Problem{"the tree does not stand at a breakpoint"});
  }
  for (KnownHook& known : hooks_) {
    if (!is_meant(known)) continue;
    known.stands = false;
    Ask(kUnlock, groot2::WriteUnlock(known.uid, known.hook.position, result),
        [left, on_reply](const Answer& answer) {
          if (--*left == 0) Reply(on_reply, ReplyOf(answer.payload));
        });
  }
}

}  // namespace coppice
