#include <cstdlib>
#include <optional>
#include <string>

#include "bt_core/live/server/live_clients.h"
#include "bt_core/live/zmtp/zmtp_curve_client.h"
#include "bt_core/live/zmtp/zmtp_peer.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/served_tree.h"

namespace coppice::fuzz {
namespace {

using zmtp::FrameReader;
using zmtp::ZmtpPeer;

constexpr char kToken[] = "a token for fuzzing";

const RobotKeys& Robot() {
  static const RobotKeys keys = KeysOfRobot(kToken);
  return keys;
}

const WatcherKeys& Watcher(bool may_control) {
  static const WatcherKeys control = KeysOfWatcher(kToken);
  static const WatcherKeys read = KeysOfWatcher(Robot().read_token);
  return may_control ? control : read;
}

// A connection of which a robot reads the one end, and the fuzzer writes the other.
class Connection : private CheckingOutbox {
 public:
  // 'N' no token, 'C' the control token, 'R' the read token; 'S' the port of notifications.
  explicit Connection(char kind)
      : peer_(kind == 'S' ? ZmtpPeer::Type::kPublisher : ZmtpPeer::Type::kRouter,
              kind == 'C' || kind == 'R' ? &Robot() : nullptr, LiveClients::kMaxRequestBytes) {
    if (kind == 'C' || kind == 'R') curve_.emplace(Watcher(kind == 'C'));
    Listen(peer_.TakeOutput());
  }

  // False when the robot hangs up.
  bool Do(const LooseFrame& step) {
    switch (step.type) {
      case 'h':
        return Say(
            zmtp::kCommand,
            curve_ ? Damaged(zmtp::MakeCommand("HELLO", curve_->Hello()), step.payload) : "");
      case 'i':
        return Say(zmtp::kCommand,
                   curve_ ? zmtp::MakeCommand("INITIATE", curve_->Initiate(step.payload))
                          : zmtp::MakeCommand("READY", step.payload));
      case 'm':
      case 'M':
        return Part(step.type == 'M', step.payload);
      case 'p':
        return Part(true, step.payload, true);
      case 'w':
        tree_.OutlastClients();
        return true;
      default:
        return Take(step.payload);
    }
  }

  // As FuzzZmtp returns it.
  int reached() const { return good > 0 ? 3 : requests_ > 0 ? 2 : peer_.is_open(); }

 private:
  // Pairs of a place and the bits to change there.
  static std::string Damaged(std::string text, std::string_view pairs) {
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) {
      text[static_cast<unsigned char>(pairs[i]) % text.size()] ^= pairs[i + 1];
    }
    return text;
  }

  bool Part(bool has_more, std::string_view body, bool is_command = false) {
    if (curve_) {
      const int flags =
          (has_more && !is_command ? zmtp::kCurveMore : 0) | (is_command ? zmtp::kCurveCommand : 0);
      return Say(0, curve_->Seal(static_cast<std::uint8_t>(flags), body));
    }
    return Say(is_command ? zmtp::kCommand : has_more ? zmtp::kMore : 0, body);
  }

  bool Say(std::uint8_t flags, std::string_view body) {
    std::string frame;
    zmtp::AppendFrame(flags, body, frame);
    return Take(frame);
  }

  bool Take(std::string_view bytes) {
    peer_.Receive(bytes);
    groot2::Parts message;
    for (;;) {
      const ZmtpPeer::Step step = peer_.Next(message);
      Listen(peer_.TakeOutput());
      if (step != ZmtpPeer::Step::kMessage) return step == ZmtpPeer::Step::kIncomplete;
      if (!peer_.is_open() || message.empty()) std::abort();
      if (message.size() < 2 || !message.front().empty()) continue;
      message.erase(message.begin());
      ++requests_;
      tree_.Serve(ClientId(1), peer_.may_control(), message);
    }
  }

  SendResult Send(ClientId client, const groot2::Parts& parts) override {
    const SendResult result = CheckingOutbox::Send(client, parts);
    Listen(peer_.Encode(parts));
    return result;
  }

  // What the robot says are a greeting and whole frames.
  void Listen(std::string_view bytes) {
    heard_.Append(bytes);
    std::string_view greeting;
    if (!has_greeting_ &&
        heard_.TakeBytes(zmtp::kGreetingSize, greeting) != FrameReader::Result::kDone) {
      std::abort();
    }
    has_greeting_ = true;
    std::uint8_t flags = 0;
    std::string frame;
    FrameReader::Result result = FrameReader::Result::kDone;
    while ((result = heard_.TakeFrame(SIZE_MAX, flags, frame)) == FrameReader::Result::kDone) {
      std::string_view body = frame;
      if (curve_ && zmtp::TakeName(body) == "WELCOME" && !curve_->Welcome(body)) std::abort();
    }
    std::string_view rest;
    if (heard_.TakeBytes(1, rest) == FrameReader::Result::kDone) std::abort();
  }

  ZmtpPeer peer_;
  std::optional<zmtp::CurveClient> curve_;
  FrameReader heard_;
  bool has_greeting_ = false;
  int requests_ = 0;
  ServedTree tree_{*this};
};

}  // namespace

int FuzzZmtp(std::string_view bytes) {
  if (bytes.empty()) return 0;
  Connection connection(bytes[0]);
  bytes.remove_prefix(1);
  LooseFrame step;
  while (TakeFrame(bytes, step) && connection.Do(step)) continue;
  return connection.reached();
}

}  // namespace coppice::fuzz
