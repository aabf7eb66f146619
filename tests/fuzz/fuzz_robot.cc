#include <cstdlib>
#include <optional>
#include <string>

#include "bt_core/live/zmtp/zmtp_client.h"
#include "bt_core/live/zmtp/zmtp_curve.h"
#include "tests/fuzz/frames.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

using zmtp::FrameReader;
using zmtp::ZmtpClient;

constexpr char kToken[] = "a token for fuzzing";
constexpr std::size_t kLimit = 1 << 16;

const RobotKeys& Robot() {
  static const RobotKeys keys = KeysOfRobot(kToken);
  return keys;
}

const WatcherKeys& Watcher() {
  static const WatcherKeys keys = KeysOfWatcher(kToken);
  return keys;
}

// A connection of which a client reads the one end, and the fuzzer is the robot at the other.
class Connection {
 public:
  explicit Connection(char kind)
      : client_(kind == 'S' ? ZmtpClient::Type::kListener : ZmtpClient::Type::kDealer,
                kind == 'C' ? &Watcher() : nullptr, kLimit) {
    if (kind == 'C') curve_.emplace(Robot());
    Listen();
  }

  // False when the client hangs up.
  bool Do(const LooseFrame& step) {
    switch (step.type) {
      case 'h':
        return Say(zmtp::kCommand, zmtp::MakeCommand("WELCOME", welcome_));
      case 'i':
        return Say(zmtp::kCommand, zmtp::MakeCommand("READY", Ready(step.payload)));
      case 'm':
      case 'M':
        return Part(step.type == 'M' ? 1 : 0, step.payload);
      case 'p':
        return Part(zmtp::kCurveCommand, step.payload);
      default:
        return Take(step.payload);
    }
  }

  // As FuzzRobot returns it.
  int reached() const { return has_message_ ? 2 : client_.is_open(); }

 private:
  std::string Ready(std::string_view properties) {
    return is_initiated_ ? curve_->Ready(properties) : std::string(properties);
  }

  bool Part(std::uint8_t flags, std::string_view body) {
    if (is_initiated_) return Say(0, curve_->Seal(flags, body));
    if (flags == zmtp::kCurveCommand) return Say(zmtp::kCommand, body);
    return Say(flags, body);
  }

  bool Say(std::uint8_t flags, std::string_view body) {
    std::string frame;
    zmtp::AppendFrame(flags, body, frame);
    return Take(frame);
  }

  bool Take(std::string_view bytes) {
    client_.Receive(bytes);
    groot2::Parts message;
    for (;;) {
      const auto step = client_.Next(message);
      Listen();
      if (step != ZmtpClient::Step::kMessage) return step == ZmtpClient::Step::kIncomplete;
      std::size_t size = 0;
      for (const std::string& part : message) size += part.size();
      if (!client_.is_open() || message.empty() || message.size() > ZmtpClient::kMaxParts ||
          size > kLimit) {
        std::abort();
      }
      has_message_ = true;
      client_.Encode(message);
    }
  }

  // What the client says are a greeting and whole frames.
  void Listen() {
    heard_.Append(client_.TakeOutput());
    std::string_view greeting;
    if (!has_greeting_ &&
        heard_.TakeBytes(zmtp::kGreetingSize, greeting) != FrameReader::Result::kDone) {
      std::abort();
    }
    has_greeting_ = true;
    std::uint8_t flags = 0;
    std::string frame;
    while (heard_.TakeFrame(SIZE_MAX, flags, frame) == FrameReader::Result::kDone) {
      if (curve_ && (flags & zmtp::kCommand)) OnCommand(frame);
    }
    if (heard_.TakeBytes(1, greeting) == FrameReader::Result::kDone) std::abort();
  }

  void OnCommand(std::string_view body) {
    const std::string_view name = zmtp::TakeName(body);
    if (name == "HELLO") welcome_ = curve_->Welcome(body).value();
    std::string properties;
    if (name == "INITIATE" && !curve_->Initiate(body, properties)) std::abort();
    is_initiated_ = is_initiated_ || name == "INITIATE";
  }

  ZmtpClient client_;
  std::optional<zmtp::CurveConnection> curve_;
  std::string welcome_;
  bool is_initiated_ = false;
  FrameReader heard_;
  bool has_greeting_ = false;
  bool has_message_ = false;
};

}  // namespace

int FuzzRobot(std::string_view bytes) {
  if (bytes.empty()) return 0;
  Connection connection(bytes[0]);
  bytes.remove_prefix(1);
  LooseFrame step;
  while (TakeFrame(bytes, step) && connection.Do(step)) continue;
  return connection.reached();
}

}  // namespace coppice::fuzz
