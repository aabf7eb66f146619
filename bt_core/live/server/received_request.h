// A request as it arrives, by whatever way.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_RECEIVED_REQUEST_H_
#define COPPICE_BT_CORE_LIVE_SERVER_RECEIVED_REQUEST_H_

#include "bt_core/base/clock.h"
#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/server/live_outbox.h"

namespace coppice {

struct ReceivedRequest {
  ClientId client{};  ///< whom to answer
  bool may_control = false;
  Duration arrived{0};  ///< in real time
  groot2::Parts parts;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_RECEIVED_REQUEST_H_
