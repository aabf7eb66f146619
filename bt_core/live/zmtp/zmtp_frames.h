// The frames of ZMTP 3.0, the protocol of ZeroMQ on TCP: greeting, frames, commands and their
// properties. Knows no sockets; any bytes may be handed in.
// Source: RFC 23 of ZeroMQ (rfc.zeromq.org/spec/23).
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_FRAMES_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_FRAMES_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace coppice::zmtp {

inline constexpr std::size_t kGreetingSize = 64;

/// What both sides say first. `mechanism`: "NULL" or "CURVE"; of CURVE one side is the server.
std::string MakeGreeting(std::string_view mechanism, bool is_server = false);
/// Whether `greeting`, of kGreetingSize bytes, is of this version or a later one, and names the
/// mechanism.
bool IsGreetingOf(std::string_view greeting, std::string_view mechanism);

/// Bits of a frame's first byte.
enum FrameFlags : std::uint8_t { kMore = 1, kLong = 2, kCommand = 4 };

void AppendFrame(std::uint8_t flags, std::string_view body, std::string& out);

/// Cuts what arrives into greeting and frames. Keeps what was handed in last and one frame; memory
/// for that is taken as it comes, not as it is announced.
class FrameReader {
 public:
  enum class Result : std::uint8_t { kDone, kIncomplete, kTooLarge };

  void Append(std::string_view bytes);
  /// The view holds until the next call of anything. Not inside a frame.
  Result TakeBytes(std::size_t size, std::string_view& bytes);
  /// A frame that is longer than `limit` is refused as soon as its length is there.
  Result TakeFrame(std::size_t limit, std::uint8_t& flags, std::string& body);
  /// Bytes of the frame that comes.
  std::size_t come() const { return body_.size(); }

 private:
  std::string_view rest() const { return std::string_view(bytes_).substr(used_); }
  Result TakeHeader(std::size_t limit);
  void TakeBody();

  std::string bytes_;
  std::size_t used_ = 0;

  bool is_in_frame_ = false;  // its header was taken
  std::uint8_t flags_ = 0;
  std::size_t size_ = 0;
  std::string body_;  // as far as it has come
};

/// "\5READY..." -> "READY"; `body` becomes what follows. Empty if it is no command.
std::string_view TakeName(std::string_view& body);
std::string MakeCommand(std::string_view name, std::string_view body);

void AppendProperty(std::string_view name, std::string_view value, std::string& out);
/// Empty if it is not there, or the properties are not well formed.
std::string FindProperty(std::string_view properties, std::string_view name);

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_FRAMES_H_
