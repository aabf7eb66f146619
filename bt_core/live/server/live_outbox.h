// Where answers and pushes go.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_
#define COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_

#include <cstdint>
#include <string>

#include "bt_core/live/groot2/groot2_protocol.h"

namespace coppice {

enum class SendResult : std::uint8_t {
  kSent,
  kFull,  ///< the client does not read what it was sent before
  kGone,
};

class LiveOutbox {
 public:
  virtual ~LiveOutbox() = default;
  /// To one client. Never waits.
  virtual SendResult Send(const std::string& client, const groot2::Parts& parts) = 0;
  /// To everybody who listens to notifications.
  virtual void Publish(const groot2::Parts& parts) = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_LIVE_OUTBOX_H_
