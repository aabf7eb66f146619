// One connection that speaks the protocol of ZeroMQ: bytes in, whole messages out, and back; what
// the robot's end (zmtp_peer.h) and the client's (zmtp_client.h) have in common. Knows no sockets;
// any bytes may be handed in.
//
//   stream.Receive(bytes);
//   while (stream.Next(message) == ZmtpStream::Step::kMessage) ...
//   write(stream.TakeOutput());
//
// Keeps one message, and of that no more than its limits: a message of ever more parts, or of one
// that does not end, is refused.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_STREAM_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_STREAM_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/zmtp/zmtp_curve_session.h"
#include "bt_core/live/zmtp/zmtp_frames.h"

namespace coppice::zmtp {

class ZmtpStream {
 public:
  static constexpr std::size_t kMaxParts = 8;

  virtual ~ZmtpStream() = default;
  ZmtpStream(const ZmtpStream&) = delete;
  ZmtpStream& operator=(const ZmtpStream&) = delete;

  /// Bytes that have arrived.
  void Receive(std::string_view bytes) { reader_.Append(bytes); }

  enum class Step : std::uint8_t { kMessage, kIncomplete, kRefused };
  /// The next whole message in what has arrived. Refused: hang up when the output is written.
  Step Next(groot2::Parts& message);

  /// Bytes of the message that comes.
  std::size_t come() const { return size_ + reader_.come(); }

  /// What the protocol itself has to say; never much. To be taken before anything is encoded: what
  /// is encrypted keeps its order.
  std::string TakeOutput() { return std::exchange(output_, {}); }

  /// Messages go to and fro: the other end is one that may connect.
  bool is_open() const { return is_open_; }

  /// A message on its way to the other end, once is_open().
  std::string Encode(const groot2::Parts& message);

 protected:
  /// `max_bytes`: of a message.
  ZmtpStream(bool is_server, bool has_curve, std::size_t max_bytes);

  /// The other end speaks this version and mechanism.
  virtual void OnGreeting() {}
  /// A command before it is open; false ends the connection.
  virtual bool TakeCommand(std::string_view name, std::string_view body) = 0;

  void Say(std::string_view name, std::string_view body);
  void Send(const groot2::Parts& message) { output_ += Encode(message); }
  /// `curve`: null without encryption; else must live as long.
  void Open(CurveSession* curve);

 private:
  bool TakeFrame(std::uint8_t flags, std::string body);
  bool TakePart(bool has_more, std::string part);
  void Answer(std::string_view command);

  const char* const mechanism_;
  const std::size_t max_bytes_;
  bool is_greeted_ = false;
  bool is_open_ = false;
  CurveSession* curve_ = nullptr;
  FrameReader reader_;
  std::string output_;
  groot2::Parts parts_;  // of the message that comes
  std::size_t size_ = 0;
  bool is_whole_ = false;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_STREAM_H_
