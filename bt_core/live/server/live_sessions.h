// Who is connected by the extension of the protocol: trees, clients, and what each client follows.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_SESSIONS_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_SESSIONS_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "bt_core/live/server/live_outbox.h"
#include "bt_core/live/server/live_tree.h"
#include "bt_core/live/server/subscription.h"

namespace coppice {

/// The trees of an endpoint by their number.
using LiveTrees = std::map<std::uint32_t, std::shared_ptr<LiveTree>>;

struct ActiveSubscription {
  ActiveSubscription(std::shared_ptr<LiveTree> followed, Subscription::From from,
                     std::uint64_t number, std::size_t window);
  ~ActiveSubscription();
  ActiveSubscription(const ActiveSubscription&) = delete;
  ActiveSubscription& operator=(const ActiveSubscription&) = delete;

  std::shared_ptr<LiveTree> tree;
  Subscription frames;
};

struct Session {
  OwnerId owner = 0;
  bool may_control = false;  ///< when it began; what it asks for is judged by its request
  std::string name;          ///< what it calls itself
  Duration last_request{0};  ///< when it arrived, in real time
  std::uint32_t last_subscription = 0;
  std::map<std::uint32_t, ActiveSubscription> subscriptions;  ///< one for a tree at most
  /// The change of LivePictures that it was sent last; none: it has not asked for pictures.
  std::optional<std::uint64_t> pictures_seen;

  /// It follows the tree no longer.
  void Unfollow(const LiveTree& tree);
};

class LiveSessions {
 public:
  static constexpr std::size_t kMaxSessions = 64;
  static constexpr std::size_t kMaxReaders = kMaxSessions / 2;  ///< those who may not control

  explicit LiveSessions(const LiveTrees& trees) : trees_(trees) {}

  /// Null if the client has not said hello.
  Session* Find(ClientId client);
  /// A new session in place of the one that it may have. Null if there are too many.
  Session* Open(ClientId client, bool may_control, Duration now);
  /// What it holds is released.
  void Close(ClientId client);
  /// Nobody follows the tree any more.
  void Forget(const LiveTree& tree);

  using Map = std::map<ClientId, Session>;
  Map& all() { return sessions_; }

 private:
  const LiveTrees& trees_;
  Map sessions_;
  OwnerId last_owner_ = LiveTree::kFirstClientOwner;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_SESSIONS_H_
