// The ports for clients of ZeroMQ and those who came through them, for tests.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_ZMTP_LIVE_DOOR_H_
#define COPPICE_TESTS_BT_CORE_LIVE_ZMTP_LIVE_DOOR_H_

#include <chrono>
#include <optional>

#include "bt_core/base/wake_up.h"
#include "bt_core/live/zmtp/zmtp_gateway.h"

namespace coppice {

struct LiveDoor {
  explicit LiveDoor(std::optional<RobotKeys> keys = {})
      : gateway("127.0.0.1", 0, std::move(keys), clients) {}

  /// Nothing if no request comes in time.
  std::optional<ReceivedRequest> Receive(
      std::chrono::milliseconds patience = std::chrono::seconds(30)) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    ReceivedRequest request;
    while (!clients.Receive(request)) {
      const auto left = deadline - std::chrono::steady_clock::now();
      if (left <= std::chrono::nanoseconds::zero()) return std::nullopt;
      wake_up.WaitFor(left);
    }
    return request;
  }

  WakeUp wake_up;
  LiveClients clients{[this] { wake_up.Notify(); }};
  ZmtpGateway gateway;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_ZMTP_LIVE_DOOR_H_
