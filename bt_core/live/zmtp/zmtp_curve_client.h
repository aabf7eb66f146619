// The client's end of CURVE: whether the robot is the one whose token it has. zmtp_curve_session.h
// has the rest.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_CLIENT_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_CLIENT_H_

#include <string>
#include <string_view>

#include "bt_core/live/server/token_keys.h"
#include "bt_core/live/zmtp/zmtp_curve_session.h"

namespace coppice::zmtp {

class CurveClient final : public CurveSession {
 public:
  /// `keys` must live longer.
  explicit CurveClient(const WatcherKeys& keys);

  // The commands in the order in which they come: bodies without the name. False if the other end
  // is not the robot.
  std::string Hello();
  bool Welcome(std::string_view welcome);
  bool is_welcome() const { return is_welcome_; }
  std::string Initiate(std::string_view properties);
  /// `properties`: those of the robot.
  bool Ready(std::string_view ready, std::string& properties);

 private:
  const WatcherKeys& keys_;
  std::string short_robot_;  // S'
  std::string cookie_;
  bool is_welcome_ = false;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_CLIENT_H_
