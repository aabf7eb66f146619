#include "bt_core/live/server/live_desk.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace coppice {
namespace {

using groot2::Parts;
using groot2::Request;

constexpr char kFrames = 'F';
constexpr char kNotice = 'E';
constexpr int kPushesAtOnce = 4;  // to one subscription, before others have their turn
constexpr Duration kLongWait = std::chrono::milliseconds(100);
constexpr Duration kShortWait = std::chrono::milliseconds(5);

void AppendNumber(std::string& out, std::uint64_t number) {
  for (int shift = 0; shift < 64; shift += 8) out += static_cast<char>(number >> shift & 0xff);
}

Parts MakePush(std::uint32_t subscription, const RunId& run, const Push& push) {
  std::string header = groot2::MakeHeader(kFrames, subscription);
  header.append(reinterpret_cast<const char*>(run.data()), run.size());
  std::string body;
  body.reserve(16 + push.frames.size());
  AppendNumber(body, push.first);
  AppendNumber(body, push.next);
  body += push.frames;
  return {std::move(header), std::move(body)};
}

}  // namespace

LiveDesk::LiveDesk(LiveOutbox& outbox, Duration deadline,
                   std::shared_ptr<const LivePictures> pictures)
    : outbox_(outbox),
      deadline_(deadline),
      pictures_(std::move(pictures)),
      extension_(trees_, sessions_, deadline, pictures_ != nullptr) {}

LiveDesk::~LiveDesk() = default;

void LiveDesk::Add(std::shared_ptr<LiveTree> tree, Duration now) {
  const std::uint32_t number = next_tree_++;
  const Duration wait = tree->options().wait_for_client;
  entries_[number] = {std::make_unique<Groot2Service>(tree, deadline_),
                      wait > Duration::zero() ? now + wait : Duration::zero()};
  trees_[number] = std::move(tree);
  Notify(extension_.DescribeTrees());
}

std::string LiveDesk::first_tree() const {
  return trees_.empty() ? "" : trees_.begin()->second->Info().name;
}

void LiveDesk::Remove(const LiveTree& tree) {
  const auto at = std::find_if(trees_.begin(), trees_.end(),
                               [&](const auto& entry) { return entry.second.get() == &tree; });
  if (at == trees_.end()) return;
  at->second->EndHistory();
  TellDebugEvents();
  while (PushAll() == Progress::kMore) {
  }
  sessions_.Forget(tree);
  entries_.erase(at->first);
  trees_.erase(at);
  Notify(extension_.DescribeTrees());
}

void LiveDesk::Serve(ClientId client, bool may_control, const Parts& request, Duration arrived) {
  const Parts reply = Answer(client, may_control, request, arrived);
  if (reply.empty()) return;
  if (outbox_.Reply(client, reply) == SendResult::kGone) sessions_.Close(client);
}

// Empty: no reply is wanted.
Parts LiveDesk::Answer(ClientId client, bool may_control, const Parts& parts, Duration arrived) {
  const auto parsed = groot2::ParseRequest(parts);
  if (!parsed) return groot2::MakeError(parsed.problem());
  const Request& request = *parsed;
  if (request.type == groot2::RequestType::kExtension) {
    ExtensionService::Answer answer =
        extension_.Serve(client, may_control, request.argument, arrived);
    if (request.number == 0 && !answer.failed) return {};
    return groot2::MakeReply(request, server_id_, std::move(answer.json));
  }
  if (entries_.empty()) return groot2::MakeError("no tree is running here now");
  return entries_.begin()->second.groot2->Answer(request, may_control, arrived);
}

Duration LiveDesk::Attend(Duration now, Duration heard_until) {
  TellDebugEvents();
  TellChangedTrees();
  ReleaseWaiting(now);
  Expire(std::max(heard_until, now - deadline_));
  ShowPictures();
  const Progress progress = PushAll();
  if (progress == Progress::kMore) return now;
  return now + (progress == Progress::kBlocked ? kShortWait : std::min(kLongWait, deadline_ / 4));
}

void LiveDesk::TellDebugEvents() {
  for (const auto& [number, tree] : trees_) {
    for (const DebugEvent& event : tree->TakeDebugEvents()) {
      Notify(extension_.Describe(number, event));
      const Parts notification = entries_.at(number).groot2->Notification(event);
      if (!notification.empty()) outbox_.Publish(notification);
    }
  }
}

void LiveDesk::TellChangedTrees() {
  bool changed = false;
  for (const auto& [number, tree] : trees_) changed = tree->TakeProgramChange() || changed;
  if (changed) Notify(extension_.DescribeTrees());
}

Parts LiveDesk::NoticeOf(const std::string& json) const {
  return groot2::MakeReply({static_cast<groot2::RequestType>(kNotice), 0, {}}, server_id_, json);
}

void LiveDesk::Notify(const std::string& notice) {
  const Parts parts = NoticeOf(notice);
  std::vector<ClientId> gone;
  for (const auto& [client, session] : sessions_.all()) {
    if (outbox_.Send(client, parts) == SendResult::kGone) gone.push_back(client);
  }
  for (const ClientId client : gone) sessions_.Close(client);
}

void LiveDesk::ReleaseWaiting(Duration now) {
  for (auto& [number, entry] : entries_) {
    if (entry.wait_until == Duration::zero() || now < entry.wait_until) continue;
    entry.wait_until = Duration::zero();
    trees_.at(number)->debugger().Release(LiveTree::kWaitOwner);
  }
}

void LiveDesk::Expire(Duration heard_until) {
  for (auto& [number, entry] : entries_) entry.groot2->Expire(heard_until);
  std::vector<ClientId> dead;
  for (const auto& [client, session] : sessions_.all()) {
    if (heard_until - session.last_request >= deadline_) dead.push_back(client);
  }
  for (const ClientId client : dead) {
    sessions_.Close(client);
    outbox_.Send(client, NoticeOf(extension_.DescribeRelease()));
  }
}

// Who does not read is shown the newest ones when he does.
void LiveDesk::ShowPictures() {
  if (!pictures_) return;
  std::vector<ClientId> gone;
  for (auto& [client, session] : sessions_.all()) {
    if (!session.pictures_seen) continue;
    std::uint64_t seen = *session.pictures_seen;
    SendResult result = SendResult::kSent;
    while (const std::optional<LivePicture> picture = pictures_->Next(seen)) {
      result = outbox_.Send(client, NoticeOf(ExtensionService::Describe(*picture)));
      if (result != SendResult::kSent) break;
      session.pictures_seen = seen;
    }
    if (result == SendResult::kGone) gone.push_back(client);
  }
  for (const ClientId client : gone) sessions_.Close(client);
}

LiveDesk::Progress LiveDesk::PushAll() {
  Progress result = Progress::kDone;
  std::vector<ClientId> gone;
  for (auto& [client, session] : sessions_.all()) {
    for (auto& [id, subscription] : session.subscriptions) {
      const Progress progress = PushTo(client, id, subscription);
      if (progress == Progress::kGone) {
        gone.push_back(client);
        break;
      }
      if (result != Progress::kMore && progress != Progress::kDone) result = progress;
    }
  }
  for (const ClientId client : gone) sessions_.Close(client);
  return result;
}

LiveDesk::Progress LiveDesk::PushTo(ClientId client, std::uint32_t id,
                                    ActiveSubscription& subscription) {
  const RunId& run = subscription.tree->run();
  for (int pushed = 0; pushed < kPushesAtOnce; ++pushed) {
    const std::size_t room = outbox_.RoomFor(client);
    const std::optional<Push> push = subscription.tree->UseFrames(
        [&](const FrameStore& store) { return subscription.frames.Next(store, room); });
    if (!push) return Progress::kDone;
    if (push->frames.empty()) return Progress::kBlocked;
    if (outbox_.Send(client, MakePush(id, run, *push)) != SendResult::kSent) return Progress::kGone;
  }
  return Progress::kMore;
}

}  // namespace coppice
