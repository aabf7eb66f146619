#include "bt_core/live/zmtp/zmtp_frames.h"

#include <utility>

namespace coppice::zmtp {
namespace {

constexpr std::size_t kMechanismSize = 20;
constexpr std::size_t kMechanismAt = 12;

std::uint64_t ReadNumber(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char byte : bytes) number = number << 8 | static_cast<unsigned char>(byte);
  return number;
}

void AppendNumber(std::uint64_t number, int size, std::string& out) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
    out += static_cast<char>(number >> shift & 0xff);
  }
}

// Its length comes first, in so many bytes.
bool TakeText(std::size_t length_size, std::string_view& bytes, std::string_view& text) {
  if (bytes.size() < length_size) return false;
  const std::uint64_t length = ReadNumber(bytes.substr(0, length_size));
  bytes.remove_prefix(length_size);
  if (bytes.size() < length) return false;
  text = bytes.substr(0, length);
  bytes.remove_prefix(length);
  return true;
}

std::string Padded(std::string_view mechanism) {
  std::string padded(mechanism);
  padded.resize(kMechanismSize);
  return padded;
}

}  // namespace

std::string MakeGreeting(std::string_view mechanism, bool is_server) {
  std::string greeting("\xff\0\0\0\0\0\0\0\1\x7f\3\0", kMechanismAt);
  greeting += Padded(mechanism);
  greeting += static_cast<char>(is_server);
  greeting.resize(kGreetingSize);
  return greeting;
}

bool IsGreetingOf(std::string_view greeting, std::string_view mechanism) {
  return greeting[0] == '\xff' && greeting[9] == '\x7f' && greeting[10] >= 3 &&
         greeting.substr(kMechanismAt, kMechanismSize) == Padded(mechanism);
}

void AppendFrame(std::uint8_t flags, std::string_view body, std::string& out) {
  const bool is_long = body.size() > UINT8_MAX;
  out += static_cast<char>(flags | (is_long ? kLong : 0));
  AppendNumber(body.size(), is_long ? 8 : 1, out);
  out += body;
}

void FrameReader::Append(std::string_view bytes) {
  bytes_.erase(0, used_);
  used_ = 0;
  bytes_ += bytes;
}

FrameReader::Result FrameReader::TakeBytes(std::size_t size, std::string_view& bytes) {
  if (rest().size() < size) return Result::kIncomplete;
  bytes = rest().substr(0, size);
  used_ += size;
  return Result::kDone;
}

FrameReader::Result FrameReader::TakeFrame(std::size_t limit, std::uint8_t& flags,
                                           std::string& body) {
  if (!is_in_frame_) {
    const Result result = TakeHeader(limit);
    if (result != Result::kDone) return result;
  }
  TakeBody();
  if (body_.size() < size_) return Result::kIncomplete;
  is_in_frame_ = false;
  flags = flags_;
  body = std::exchange(body_, {});
  return Result::kDone;
}

FrameReader::Result FrameReader::TakeHeader(std::size_t limit) {
  if (rest().empty()) return Result::kIncomplete;
  const auto flags = static_cast<std::uint8_t>(rest()[0]);
  const std::size_t header = 1 + ((flags & kLong) ? 8 : 1);
  if (rest().size() < header) return Result::kIncomplete;
  const std::uint64_t size = ReadNumber(rest().substr(1, header - 1));
  if (size > limit) return Result::kTooLarge;
  used_ += header;
  is_in_frame_ = true;
  flags_ = flags;
  size_ = size;
  return Result::kDone;
}

// Memory is at most four times of what has come, and while it moves never more than the frame.
void FrameReader::TakeBody() {
  const std::string_view piece = rest().substr(0, size_ - body_.size());
  const std::size_t needed = body_.size() + piece.size();
  if (needed > body_.capacity()) body_.reserve(size_ / 4 <= needed ? size_ : 2 * needed);
  body_ += piece;
  used_ += piece.size();
}

std::string_view TakeName(std::string_view& body) {
  std::string_view name;
  return TakeText(1, body, name) ? name : std::string_view();
}

std::string MakeCommand(std::string_view name, std::string_view body) {
  std::string command(1, static_cast<char>(name.size()));
  command += name;
  command += body;
  return command;
}

void AppendProperty(std::string_view name, std::string_view value, std::string& out) {
  AppendNumber(name.size(), 1, out);
  out += name;
  AppendNumber(value.size(), 4, out);
  out += value;
}

std::string FindProperty(std::string_view properties, std::string_view name) {
  std::string_view found_name;
  std::string_view value;
  while (TakeText(1, properties, found_name) && TakeText(4, properties, value)) {
    if (found_name == name) return std::string(value);
  }
  return {};
}

}  // namespace coppice::zmtp
