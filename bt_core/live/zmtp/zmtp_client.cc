#include "bt_core/live/zmtp/zmtp_client.h"

namespace coppice::zmtp {

ZmtpClient::ZmtpClient(Type type, const WatcherKeys* keys, std::size_t max_bytes)
    : ZmtpStream(false, keys != nullptr, max_bytes), type_(type) {
  if (keys) curve_.emplace(*keys);
}

void ZmtpClient::OnGreeting() {
  curve_ ? Say("HELLO", curve_->Hello()) : Say("READY", Properties());
}

// ERROR, with a reason for programs, is refused as everything else is.
bool ZmtpClient::TakeCommand(std::string_view name, std::string_view body) {
  if (!curve_) return name == "READY" && OnReady(body);
  if (!curve_->is_welcome()) return name == "WELCOME" && OnWelcome(body);
  std::string properties;
  return name == "READY" && curve_->Ready(body, properties) && OnReady(properties);
}

bool ZmtpClient::OnWelcome(std::string_view body) {
  if (!curve_->Welcome(body)) return false;
  Say("INITIATE", curve_->Initiate(Properties()));
  return true;
}

bool ZmtpClient::OnReady(std::string_view properties) {
  const std::string type = FindProperty(properties, "Socket-Type");
  const bool fits = type_ == Type::kDealer ? type == "ROUTER" || type == "REP" || type == "DEALER"
                                           : type == "PUB" || type == "XPUB";
  if (!fits) return false;
  Open(curve_ ? &*curve_ : nullptr);
  if (type_ == Type::kListener) Send({"\1"});  // and no topic: everything
  return true;
}

std::string ZmtpClient::Properties() const {
  std::string properties;
  AppendProperty("Socket-Type", type_ == Type::kDealer ? "DEALER" : "SUB", properties);
  if (type_ == Type::kDealer) AppendProperty("Identity", "", properties);
  return properties;
}

}  // namespace coppice::zmtp
