#include "bt_core/live/server/live_sessions.h"

#include <algorithm>
#include <utility>

namespace coppice {

ActiveSubscription::ActiveSubscription(std::shared_ptr<LiveTree> followed, Subscription::From from,
                                       std::uint64_t number, std::size_t window)
    : tree(std::move(followed)), frames(tree->UseFrames([&](const FrameStore& store) {
        return Subscription(store, from, number, window);
      })) {
  tree->CountSubscribers(1);
}

ActiveSubscription::~ActiveSubscription() { tree->CountSubscribers(-1); }

void Session::Unfollow(const LiveTree& tree) {
  const auto at = std::find_if(subscriptions.begin(), subscriptions.end(),
                               [&](const auto& entry) { return entry.second.tree.get() == &tree; });
  if (at != subscriptions.end()) subscriptions.erase(at);
}

Session* LiveSessions::Find(ClientId client) {
  const auto session = sessions_.find(client);
  return session == sessions_.end() ? nullptr : &session->second;
}

Session* LiveSessions::Open(ClientId client, bool may_control, Duration now) {
  Close(client);
  const auto readers = static_cast<std::size_t>(
      std::count_if(sessions_.begin(), sessions_.end(),
                    [](const auto& entry) { return !entry.second.may_control; }));
  const bool is_full = sessions_.size() >= kMaxSessions;
  if (is_full || (!may_control && readers >= kMaxReaders)) return nullptr;
  Session& session = sessions_[client];
  session.may_control = may_control;
  session.owner = ++last_owner_;
  session.last_request = now;
  return &session;
}

void LiveSessions::Close(ClientId client) {
  const auto session = sessions_.find(client);
  if (session == sessions_.end()) return;
  for (const auto& [number, tree] : trees_) tree->debugger().Release(session->second.owner);
  sessions_.erase(session);
}

void LiveSessions::Forget(const LiveTree& tree) {
  for (auto& [client, session] : sessions_) session.Unfollow(tree);
}

}  // namespace coppice
