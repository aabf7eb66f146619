// The part of a live server that knows what to answer, to push and to release, and neither sockets
// nor threads. One thread at a time.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_DESK_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_DESK_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "bt_core/live/groot2/groot2_service.h"
#include "bt_core/live/pictures/live_pictures.h"
#include "bt_core/live/server/extension_service.h"
#include "bt_core/live/server/live_outbox.h"
#include "bt_core/live/server/live_sessions.h"

namespace coppice {

class LiveDesk {
 public:
  /// A client that was silent for `deadline` is taken for dead. `pictures`: null if the robot shows
  /// none.
  LiveDesk(LiveOutbox& outbox, Duration deadline,
           std::shared_ptr<const LivePictures> pictures = nullptr);
  ~LiveDesk();

  void Add(std::shared_ptr<LiveTree> tree, Duration now);
  /// After what has happened in it was sent as far as its clients take it.
  void Remove(const LiveTree& tree);

  /// The name of the one that clients see who ask for none; empty: there is none.
  std::string first_tree() const;

  /// Answers a request that arrived then. Any bytes may be handed in. Times are real time here and
  /// below.
  void Serve(ClientId client, bool may_control, const groot2::Parts& request, Duration arrived);

  /// What is due without a request: notices, pushes, what dead clients leave behind. Returns when
  /// it wants to be called again at the latest, if nobody wakes it. `heard_until`: what has arrived
  /// before was served. Nobody is taken for dead whose request may still wait; but not for ever.
  Duration Attend(Duration now, Duration heard_until);

 private:
  struct TreeEntry {
    std::unique_ptr<Groot2Service> groot2;
    Duration wait_until{0};  // for the first client; 0: no longer
  };
  enum class Progress : std::uint8_t { kDone, kMore, kBlocked, kGone };

  groot2::Parts Answer(ClientId client, bool may_control, const groot2::Parts& request,
                       Duration arrived);
  void TellDebugEvents();
  groot2::Parts NoticeOf(const std::string& json) const;
  void Notify(const std::string& notice);
  void TellChangedTrees();
  void ReleaseWaiting(Duration now);
  void Expire(Duration heard_until);
  void ShowPictures();
  Progress PushAll();
  Progress PushTo(ClientId client, std::uint32_t id, ActiveSubscription& subscription);

  LiveOutbox& outbox_;
  const Duration deadline_;
  const std::shared_ptr<const LivePictures> pictures_;
  const groot2::TreeId server_id_ = groot2::RandomTreeId();
  LiveTrees trees_;
  std::map<std::uint32_t, TreeEntry> entries_;
  std::uint32_t next_tree_ = 0;
  LiveSessions sessions_{trees_};
  ExtensionService extension_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_DESK_H_
