#include "bt_core/live/zmtp/zmtp_peer.h"

namespace coppice::zmtp {

ZmtpPeer::ZmtpPeer(Type type, const RobotKeys* keys, std::size_t max_bytes)
    : ZmtpStream(true, keys != nullptr, max_bytes), type_(type), keys_(keys) {
  if (keys_) curve_.emplace(*keys_);
}

bool ZmtpPeer::TakeCommand(std::string_view name, std::string_view body) {
  if (curve_) {
    return was_welcomed_ ? name == "INITIATE" && OnInitiate(body)
                         : name == "HELLO" && OnHello(body);
  }
  if (name != "READY" || !IsLetIn(body)) return false;
  may_control_ = true;
  Say("READY", Properties());
  Open(nullptr);
  return true;
}

bool ZmtpPeer::OnHello(std::string_view body) {
  const std::optional<std::string> welcome = curve_->Welcome(body);
  if (!welcome) return false;
  Say("WELCOME", *welcome);
  was_welcomed_ = true;
  return true;
}

bool ZmtpPeer::OnInitiate(std::string_view body) {
  std::string properties;
  if (!curve_->Initiate(body, properties)) return false;
  may_control_ = curve_->public_key() == keys_->control_client;
  if (!may_control_ && curve_->public_key() != keys_->read_client) {
    Say("ERROR", MakeCommand("400", {}));  // this key follows from no token of this robot
    return false;
  }
  if (!IsLetIn(properties)) return false;
  Say("READY", curve_->Ready(Properties()));
  Open(&*curve_);
  return true;
}

// Its Identity is passed over.
bool ZmtpPeer::IsLetIn(std::string_view properties) const {
  const std::string type = FindProperty(properties, "Socket-Type");
  return type_ == Type::kRouter ? type == "REQ" || type == "DEALER" || type == "ROUTER"
                                : type == "SUB" || type == "XSUB";
}

std::string ZmtpPeer::Properties() const {
  std::string properties;
  AppendProperty("Socket-Type", type_ == Type::kRouter ? "ROUTER" : "PUB", properties);
  if (type_ == Type::kRouter) AppendProperty("Identity", "", properties);
  return properties;
}

}  // namespace coppice::zmtp
