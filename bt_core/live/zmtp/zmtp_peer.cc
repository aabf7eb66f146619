#include "bt_core/live/zmtp/zmtp_peer.h"

#include <utility>

namespace coppice::zmtp {
namespace {

constexpr std::size_t kMaxHandshakeBytes = 4 << 10;
constexpr std::size_t kMaxPongBytes = 16;  // of what a PING wants back
constexpr std::size_t kMaxOutput = 4 << 10;

}  // namespace

ZmtpPeer::ZmtpPeer(Type type, const RobotKeys* keys, std::size_t max_bytes)
    : type_(type), keys_(keys), max_bytes_(max_bytes), output_(MakeGreeting(mechanism())) {
  if (keys_) curve_.emplace(*keys_);
}

ZmtpPeer::Step ZmtpPeer::Next(groot2::Parts& message) {
  if (state_ == State::kGreeting) {
    std::string_view greeting;
    if (reader_.TakeBytes(kGreetingSize, greeting) != FrameReader::Result::kDone) {
      return Step::kIncomplete;
    }
    if (!IsGreetingOf(greeting, mechanism())) return Step::kRefused;
    state_ = keys_ ? State::kHello : State::kReady;
  }
  while (!is_whole_) {
    std::uint8_t flags = 0;
    std::string_view body;
    const std::size_t limit =
        is_open() ? max_bytes_ - size_ + CurveConnection::kOverhead : kMaxHandshakeBytes;
    switch (reader_.TakeFrame(limit, flags, body)) {
      case FrameReader::Result::kIncomplete:
        return Step::kIncomplete;
      case FrameReader::Result::kTooLarge:
        return Step::kRefused;
      case FrameReader::Result::kDone:
        if (!(is_open() ? TakePart(flags, body) : TakeCommand(body))) return Step::kRefused;
    }
  }
  is_whole_ = false;
  size_ = 0;
  message = std::exchange(parts_, {});
  return Step::kMessage;
}

bool ZmtpPeer::TakeCommand(std::string_view body) {
  const std::string_view name = TakeName(body);
  switch (state_) {
    case State::kHello:
      return name == "HELLO" && OnHello(body);
    case State::kInitiate:
      return name == "INITIATE" && OnInitiate(body);
    default:
      if (name != "READY" || !Open(body)) return false;
      may_control_ = true;
      Say("READY", Properties());
      return true;
  }
}

bool ZmtpPeer::OnHello(std::string_view body) {
  const std::optional<std::string> welcome = curve_->Welcome(body);
  if (!welcome) return false;
  Say("WELCOME", *welcome);
  state_ = State::kInitiate;
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
  if (!Open(properties)) return false;
  Say("READY", curve_->Ready(Properties()));
  return true;
}

// Its Identity is passed over.
bool ZmtpPeer::Open(std::string_view properties) {
  const std::string type = FindProperty(properties, "Socket-Type");
  const bool fits = type_ == Type::kRouter ? type == "REQ" || type == "DEALER" || type == "ROUTER"
                                           : type == "SUB" || type == "XSUB";
  if (fits) state_ = State::kOpen;
  return fits;
}

bool ZmtpPeer::TakePart(std::uint8_t flags, std::string_view body) {
  bool has_more = flags & kMore;
  bool is_command = flags & kCommand;
  std::optional<std::string> text;
  if (curve_) {
    std::uint8_t curve_flags = 0;
    text = curve_->Open(body, curve_flags);
    if (!text) return false;
    body = *text;
    has_more = curve_flags & kCurveMore;
    is_command = curve_flags & kCurveCommand;
  }
  if (is_command) {
    OnCommand(body);
    return true;
  }
  if (parts_.size() == kMaxParts || size_ + body.size() > max_bytes_) return false;
  size_ += body.size();
  parts_.emplace_back(body);
  is_whole_ = !has_more;
  return true;
}

// A PING brings its patience (2 bytes) and what it wants back. Other commands are for others.
void ZmtpPeer::OnCommand(std::string_view body) {
  if (TakeName(body) != "PING" || body.size() < 2 || output_.size() > kMaxOutput) return;
  const std::string pong = MakeCommand("PONG", body.substr(2, kMaxPongBytes));
  if (curve_) {
    AppendFrame(0, curve_->Seal(kCurveCommand, pong), output_);
  } else {
    AppendFrame(kCommand, pong, output_);
  }
}

void ZmtpPeer::Say(std::string_view name, std::string_view body) {
  AppendFrame(kCommand, MakeCommand(name, body), output_);
}

std::string ZmtpPeer::Properties() const {
  std::string properties;
  AppendProperty("Socket-Type", type_ == Type::kRouter ? "ROUTER" : "PUB", properties);
  if (type_ == Type::kRouter) AppendProperty("Identity", "", properties);
  return properties;
}

std::string ZmtpPeer::Encode(const groot2::Parts& message) {
  std::string bytes;
  for (const std::string& part : message) {
    const bool is_last = &part == &message.back();
    if (curve_) {
      AppendFrame(0, curve_->Seal(is_last ? 0 : kCurveMore, part), bytes);
    } else {
      AppendFrame(is_last ? 0 : kMore, part, bytes);
    }
  }
  return bytes;
}

}  // namespace coppice::zmtp
