#include "bt_core/live/client/client_extension.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <utility>

#include "bt_core/live/client/client_json.h"

namespace coppice {
namespace {

constexpr Duration kPingPeriod = std::chrono::milliseconds(1000);
constexpr Duration kPatience = std::chrono::milliseconds(3000);
constexpr Duration kHeldUp = std::chrono::milliseconds(2000);  // it is asked every second
constexpr std::size_t kLongHeaderSize = 22;
constexpr char kVersion = 2;
constexpr std::size_t kMaxJson = 1 << 20;       // bytes: read, it takes many times of that
constexpr std::size_t kMaxReason = 1 << 10;     // of a refusal, for people
constexpr std::size_t kMostEarlyNotices = 100;  // the newest

template <class T>
void Append(std::string& bytes, T number) {  // little endian
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(number >> (8 * i));
}

template <class T>
T ReadNumber(std::string_view bytes, std::size_t at) {
  T number = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    number |= static_cast<T>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return number;
}

std::string Header(std::uint32_t number) {
  std::string header = {kVersion, 'C'};
  Append(header, number);
  return header;
}

}  // namespace

ClientExtension::ClientExtension(const LiveClientOptions& options, LiveListener& listener,
                                 ClientHistory& history, Sender sender)
    : options_(options), listener_(listener), history_(history), sender_(std::move(sender)) {
  connection_.protocol = LiveConnection::Protocol::kCoppice;
  Ask(WriteHello(options.name), [this](const std::string& json) { OnHello(json); });
}

// A robot that is not there yet answers the hello when it comes. What has answered once is asked
// for signs of life. Who was held up himself (a laptop that slept) has not listened: what the robot
// has said meanwhile is still to be read.
Duration ClientExtension::OnTime(Duration now) {
  const bool was_held_up = now - std::exchange(looked_, now) >= kHeldUp;
  if (heard_ == Duration(0)) return now + kPingPeriod;
  if (was_held_up) heard_ = now;
  if (pinged_ && now >= heard_ + kPatience) Fail("the robot does not answer");
  if (now >= next_ping_) {
    Ask(WriteSimple("ping"), nullptr);
    pinged_ = true;
    next_ping_ = now + kPingPeriod;
  }
  return next_ping_;
}

void ClientExtension::OnMessage(const Parts& parts, Duration now) {
  heard_ = now;
  if (parts.size() == 2 && parts[0] == "error") {  // not even the extension
    return is_subscribed_ ? Fail("the robot answers: " + parts[1].substr(0, kMaxReason))
                          : FailForProtocol();
  }
  if (parts.size() != 2 || parts[0].size() != kLongHeaderSize || parts[0][0] != kVersion) {
    return FailForProtocol();
  }
  pinged_ = false;
  if (parts[0][1] != 'F' && parts[1].size() > kMaxJson) {
    return Fail("the robot sent an answer that is too large");
  }
  switch (parts[0][1]) {
    case 'C':
      return OnReply(parts);
    case 'F':
      return OnFrames(parts);
    case 'E':
      return OnNotice(parts);
    default:
      return;  // of a newer robot
  }
}

void ClientExtension::Send(const LiveCommand& command, LiveClient::ReplyHandler on_reply) {
  Ask(WriteCommand(command, connection_.tree), [on_reply](const std::string& json) {
    if (on_reply) on_reply(ReadReply(json));
  });
}

void ClientExtension::Leave() {
  if (is_subscribed_) SendWithoutReply(WriteSimple("bye"));
}

void ClientExtension::Abandon(const std::string& why) {
  const auto pending = std::exchange(pending_, {});
  const std::string error = WriteAbandoned(why);
  for (const auto& [number, on_reply] : pending) {
    if (on_reply) on_reply(error);
  }
}

void ClientExtension::Ask(const std::string& json, ReplyHandler on_reply) {
  pending_[++number_] = std::move(on_reply);
  sender_({Header(number_), json});
}

void ClientExtension::SendWithoutReply(const std::string& json) { sender_({Header(0), json}); }

void ClientExtension::OnReply(const Parts& parts) {
  const auto at = pending_.find(ReadNumber<std::uint32_t>(parts[0], 2));
  if (at == pending_.end()) return;
  const ReplyHandler on_reply = std::move(at->second);
  pending_.erase(at);
  if (on_reply) on_reply(parts[1]);
}

void ClientExtension::OnHello(const std::string& json) {
  Expected<HelloReply> reply = ReadHello(json);
  if (!reply) return Fail(reply.problem());
  connection_.refusal = std::move(reply->refusal);
  connection_.trees = std::move(reply->trees);
  if (reply->has_pictures && options_.with_pictures) Ask(WriteSimple("pictures"), nullptr);
  Subscribe();
}

// A tree that is not there yet is waited for.
void ClientExtension::Subscribe() {
  if (is_subscribing_) return;
  if (!ChooseTree()) {
    connection_.problem = options_.tree.empty()
                              ? "the robot has no tree yet"
                              : "the robot has no tree \"" + options_.tree + "\" yet";
    listener_.OnConnection(connection_);
    return;
  }
  SubscribeRequest request;
  request.tree = connection_.tree;
  request.run = history_.run();
  request.from = history_.next();
  request.with_past = options_.with_past;
  is_subscribing_ = true;
  Ask(WriteSubscribe(request), [this](const std::string& json) { OnSubscribed(json); });
}

bool ClientExtension::ChooseTree() {
  const std::vector<std::string>& trees = connection_.trees;
  if (options_.tree.empty()) {
    connection_.tree = 0;
    return !trees.empty();
  }
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (trees[i] != options_.tree && std::to_string(i) != options_.tree) continue;
    connection_.tree = i;
    return true;
  }
  return false;
}

void ClientExtension::OnSubscribed(const std::string& json) {
  const Expected<SubscribeReply> reply = ReadSubscribe(json);
  if (!reply) return Fail(reply.problem());
  subscription_ = reply->subscription;
  is_subscribed_ = true;
  history_.Begin(reply->run, reply->next);
  connection_.run = reply->run;
  connection_.is_live = true;
  connection_.problem.clear();
  TellLive();
  Ask(WriteSimple("hooks"), [this](const std::string& hooks) { OnHooks(hooks); });
}

// Who comes while the tree stands has not heard of the stop.
void ClientExtension::OnHooks(const std::string& json) {
  NoticeMessage message = ReadNotice(json);
  if (message.notice.event.stop.where == DebugStop::Where::kNowhere) return;
  early_notices_.push_back(std::move(message.notice));
  TellNotices();
}

// A tree that the robot has taken away since has no name.
void ClientExtension::TellLive() {
  std::vector<std::string>& trees = connection_.trees;
  trees.resize(std::max(trees.size(), connection_.tree + 1));
  listener_.OnConnection(connection_);
}

void ClientExtension::OnFrames(const Parts& parts) {
  if (ReadNumber<std::uint32_t>(parts[0], 2) != subscription_ || !is_subscribed_) return;
  constexpr std::size_t kNumberSize = 8;
  if (parts[1].size() < 2 * kNumberSize) return Fail("the robot sent frames without a number");
  const auto first = ReadNumber<std::uint64_t>(parts[1], 0);
  const auto next = ReadNumber<std::uint64_t>(parts[1], kNumberSize);
  const Outcome added =
      history_.Add(first, next, std::string_view(parts[1]).substr(2 * kNumberSize));
  if (!added) return Fail(added.problem());
  TellNotices();
  SendWithoutReply(WriteAck(subscription_, next));
}

void ClientExtension::OnNotice(const Parts& parts) {
  NoticeMessage message = ReadNotice(parts[1]);
  if (message.event == "released") return Fail("the robot has given this client up");
  if (message.event == "trees") return OnTrees(message.trees);
  if (message.event == "picture") return OnPicture(std::move(message.picture));
  if (message.tree != connection_.tree) return;
  if (early_notices_.size() == kMostEarlyNotices) early_notices_.erase(early_notices_.begin());
  early_notices_.push_back(std::move(message.notice));
  TellNotices();
}

// A tree can stop before its description has come: then the notice waits for it.
void ClientExtension::TellNotices() {
  if (history_.nodes() == 0) return;
  for (LiveNotice& notice : std::exchange(early_notices_, {})) {
    NodeIndex& node = notice.event.stop.node;
    if (node >= history_.nodes()) node = kNoNode;
    listener_.OnNotice(notice);
  }
}

// What keeps no limits may be of a newer robot: it is not shown, and the tree is watched all the
// same.
void ClientExtension::OnPicture(LivePicture picture) {
  if (!options_.with_pictures) return;
  const std::string name = picture.name;
  if (pictures_.Put(std::move(picture))) listener_.OnPicture(pictures_.all().at(name));
}

void ClientExtension::OnTrees(const std::vector<std::string>& trees) {
  connection_.trees = trees;
  if (!is_subscribed_) return Subscribe();
  TellLive();
}

}  // namespace coppice
