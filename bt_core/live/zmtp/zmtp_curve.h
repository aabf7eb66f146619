// The robot's side of CURVE, ZeroMQ's encryption, for one connection: who the client is, and
// messages that nobody else can read or write. The cryptography is libsodium's.
// Source: RFC 26 of ZeroMQ (rfc.zeromq.org/spec/26); names of keys as there: C, S of client and
// server, C', S' of this connection.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/live/server/token_keys.h"

namespace coppice::zmtp {

/// Bits of the first byte of an encrypted message.
enum CurveFlags : std::uint8_t { kCurveMore = 1, kCurveCommand = 2 };

class CurveConnection {
 public:
  static constexpr std::size_t kOverhead = 33;  ///< of an encrypted message

  /// `keys` must live longer.
  explicit CurveConnection(const RobotKeys& keys);
  ~CurveConnection();
  CurveConnection(const CurveConnection&) = delete;
  CurveConnection& operator=(const CurveConnection&) = delete;

  // The commands in the order in which they come: bodies without the name. Nothing if the client
  // does not know what it must know.
  std::optional<std::string> Welcome(std::string_view hello);
  /// Then public_key() is that of the client, proven. `properties`: those of the client.
  bool Initiate(std::string_view initiate, std::string& properties);
  std::string Ready(std::string_view properties);

  const std::string& public_key() const { return client_; }

  /// A message, with its name. Open fails on what was changed, repeated or made by others.
  std::string Seal(std::uint8_t flags, std::string_view body);
  std::optional<std::string> Open(std::string_view message, std::uint8_t& flags);

 private:
  bool IsFresh(std::string_view nonce);

  const RobotKeys& keys_;
  std::string short_client_;  // C'
  std::string short_public_;  // S'
  std::string short_secret_;
  std::string cookie_;
  std::string shared_;  // of C' and S'
  std::string client_;  // C
  std::uint64_t nonce_ = 0;
  std::uint64_t client_nonce_ = 0;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_H_
