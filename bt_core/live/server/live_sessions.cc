#include "bt_core/live/server/live_sessions.h"

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

Session* LiveSessions::Find(ClientId client) {
  const auto session = sessions_.find(client);
  return session == sessions_.end() ? nullptr : &session->second;
}

Session* LiveSessions::Open(ClientId client, Duration now) {
  Close(client);
  if (sessions_.size() >= kMaxSessions) return nullptr;
  Session& session = sessions_[client];
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
  for (auto& [client, session] : sessions_) {
    auto& all = session.subscriptions;
    for (auto at = all.begin(); at != all.end();) {
      at = at->second.tree.get() == &tree ? all.erase(at) : std::next(at);
    }
  }
}

}  // namespace coppice
