// The robot's end of CURVE: who the client is. zmtp_curve_session.h has the rest.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_

#include <optional>
#include <string>
#include <string_view>

#include "bt_core/live/server/token_keys.h"
#include "bt_core/live/zmtp/zmtp_curve_session.h"

namespace coppice::zmtp {

class CurveConnection final : public CurveSession {
 public:
  /// `keys` must live longer.
  explicit CurveConnection(const RobotKeys& keys);

  // The commands in the order in which they come: bodies without the name. Nothing if the client
  // does not know what it must know.
  std::optional<std::string> Welcome(std::string_view hello);
  /// Then public_key() is that of the client, proven. `properties`: those of the client.
  bool Initiate(std::string_view initiate, std::string& properties);
  std::string Ready(std::string_view properties);

  const std::string& public_key() const { return client_; }

 private:
  const RobotKeys& keys_;
  std::string short_client_;  // C'
  std::string cookie_;
  std::string client_;  // C
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_
