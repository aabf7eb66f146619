// What both ends of CURVE have in common, ZeroMQ's encryption, for one connection: messages that
// nobody else can read or write. The cryptography is libsodium's.
// Source: RFC 26 of ZeroMQ (rfc.zeromq.org/spec/26); names of keys as there: C, S of client and
// server, C', S' of this connection.
#ifndef COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_SESSION_H_
#define COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_SESSION_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace coppice::zmtp {

/// Bits of the first byte of an encrypted message.
enum CurveFlags : std::uint8_t { kCurveMore = 1, kCurveCommand = 2 };

// Sizes in bytes.
inline constexpr std::size_t kCurveKey = 32;
inline constexpr std::size_t kCurveMac = 16;
inline constexpr std::size_t kCurveShortNonce = 8;
inline constexpr std::size_t kCurveLongNonce = 16;
inline constexpr std::size_t kCurveCookie = 96;
inline constexpr std::size_t kCurveVouch = kCurveLongNonce + kCurveMac + 2 * kCurveKey;

std::string RandomBytes(std::size_t size);

/// `nonce`: 24 bytes, the name of what it is for first. Empty for a key that nothing can be
/// encrypted for.
std::string CurveBox(std::string_view text, const std::string& nonce, const std::string& public_key,
                     const std::string& secret_key);
std::optional<std::string> OpenCurveBox(std::string_view box, const std::string& nonce,
                                        std::string_view public_key, const std::string& secret_key);

class CurveSession {
 public:
  static constexpr std::size_t kOverhead = 33;  ///< of an encrypted message

  CurveSession(const CurveSession&) = delete;
  CurveSession& operator=(const CurveSession&) = delete;

  /// A message, with its name. Open fails on what was changed, repeated or made by others, and
  /// puts the text in the place of the message.
  std::string Seal(std::uint8_t flags, std::string_view body);
  bool Open(std::string& message, std::uint8_t& flags);

 protected:
  /// The keys of this connection; names of what both ends seal.
  CurveSession(std::string_view own_messages, std::string_view messages_of_other);
  ~CurveSession();

  /// From here on messages can be sealed. False for a key that nothing can be encrypted for.
  bool ShareKey(const std::string& short_public_of_other);

  std::string NextNonce();
  /// Nonces of the other end go up: nothing can be sent again by others.
  bool IsFresh(std::string_view nonce);

  const std::string& short_public() const { return short_public_; }
  const std::string& short_secret() const { return short_secret_; }

 private:
  const std::string_view own_messages_;
  const std::string_view messages_of_other_;
  std::string short_public_;
  std::string short_secret_;
  std::string shared_;  // of C' and S'
  std::uint64_t nonce_ = 0;
  std::uint64_t nonce_of_other_ = 0;
};

}  // namespace coppice::zmtp

#endif  // COPPICE_BT_CORE_LIVE_ZMTP_ZMTP_CURVE_SESSION_H_
