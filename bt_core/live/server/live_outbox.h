// Where answers and pushes go.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_

#include <cstddef>
#include <cstdint>

#include "bt_core/live/groot2/groot2_protocol.h"

namespace coppice {

/// Numbers a connection. The robot gives it, once; no client can choose it or learn it.
enum class ClientId : std::uint64_t {};

enum class SendResult : std::uint8_t {
  kSent,
  kFull,  ///< the client does not read what it was sent before
  kGone,
};

class LiveOutbox {
 public:
  virtual ~LiveOutbox() = default;
  /// The largest message that Send would take now; one that has gone would be told so by Send.
  virtual std::size_t RoomFor(ClientId client) = 0;
  /// To one client. Never waits.
  virtual SendResult Send(ClientId client, const groot2::Parts& parts) = 0;
  /// The same for the answer to a request, which has room where there is none for what nobody asked
  /// for. Who asks on and on and does not read is hung up on.
  virtual SendResult Reply(ClientId client, const groot2::Parts& parts) = 0;
  /// To everybody who listens to notifications.
  virtual void Publish(const groot2::Parts& parts) = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_
