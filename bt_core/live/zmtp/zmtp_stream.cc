#include "bt_core/live/zmtp/zmtp_stream.h"

namespace coppice::zmtp {
namespace {

constexpr std::size_t kMaxHandshakeBytes = 4 << 10;
constexpr std::size_t kMaxPongBytes = 16;  // of what a PING wants back
constexpr std::size_t kMaxOutput = 4 << 10;

}  // namespace

ZmtpStream::ZmtpStream(bool is_server, bool has_curve, std::size_t max_bytes)
    : mechanism_(has_curve ? "CURVE" : "NULL"),
      max_bytes_(max_bytes),
      output_(MakeGreeting(mechanism_, is_server && has_curve)) {}

ZmtpStream::Step ZmtpStream::Next(groot2::Parts& message) {
  if (!is_greeted_) {
    std::string_view greeting;
    if (reader_.TakeBytes(kGreetingSize, greeting) != FrameReader::Result::kDone) {
      return Step::kIncomplete;
    }
    if (!IsGreetingOf(greeting, mechanism_)) return Step::kRefused;
    is_greeted_ = true;
    OnGreeting();
  }
  while (!is_whole_) {
    std::uint8_t flags = 0;
    std::string body;
    const std::size_t overhead = curve_ ? CurveSession::kOverhead : 0;
    switch (reader_.TakeFrame(is_open_ ? max_bytes_ - size_ + overhead : kMaxHandshakeBytes, flags,
                              body)) {
      case FrameReader::Result::kIncomplete:
        return Step::kIncomplete;
      case FrameReader::Result::kTooLarge:
        return Step::kRefused;
      case FrameReader::Result::kDone:
        if (!TakeFrame(flags, std::move(body))) return Step::kRefused;
    }
  }
  is_whole_ = false;
  size_ = 0;
  message = std::exchange(parts_, {});
  return Step::kMessage;
}

bool ZmtpStream::TakeFrame(std::uint8_t flags, std::string body) {
  if (!is_open_) {
    std::string_view command = body;
    const std::string_view name = TakeName(command);
    return TakeCommand(name, command);
  }
  bool has_more = flags & kMore;
  bool is_command = flags & kCommand;
  if (curve_) {
    std::uint8_t curve_flags = 0;
    if (!curve_->Open(body, curve_flags)) return false;
    has_more = curve_flags & kCurveMore;
    is_command = curve_flags & kCurveCommand;
  }
  if (!is_command) return TakePart(has_more, std::move(body));
  Answer(body);
  return true;
}

bool ZmtpStream::TakePart(bool has_more, std::string part) {
  if (parts_.size() == kMaxParts || size_ + part.size() > max_bytes_) return false;
  size_ += part.size();
  parts_.push_back(std::move(part));
  is_whole_ = !has_more;
  return true;
}

// A PING brings its patience (2 bytes) and what it wants back. Other commands are for others.
void ZmtpStream::Answer(std::string_view command) {
  if (TakeName(command) != "PING" || command.size() < 2 || output_.size() > kMaxOutput) return;
  const std::string pong = MakeCommand("PONG", command.substr(2, kMaxPongBytes));
  if (curve_) {
    AppendFrame(0, curve_->Seal(kCurveCommand, pong), output_);
  } else {
    AppendFrame(kCommand, pong, output_);
  }
}

void ZmtpStream::Say(std::string_view name, std::string_view body) {
  AppendFrame(kCommand, MakeCommand(name, body), output_);
}

void ZmtpStream::Open(CurveSession* curve) {
  is_open_ = true;
  curve_ = curve;
}

std::string ZmtpStream::Encode(const groot2::Parts& message) {
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
