#include "bt_core/live/zmtp/zmtp_curve.h"

#include <sodium.h>

namespace coppice::zmtp {

CurveConnection::CurveConnection(const RobotKeys& keys)
    : CurveSession("CurveZMQMESSAGES", "CurveZMQMESSAGEC"),
      keys_(keys),
      short_client_(kCurveKey, '\0'),
      cookie_(RandomBytes(kCurveCookie)) {}

// Version (2), zeros (72), C', nonce (8), box of 64 zeros.
std::optional<std::string> CurveConnection::Welcome(std::string_view hello) {
  constexpr std::size_t kBefore = 2 + 72;
  constexpr std::size_t kBeforeBox = kBefore + kCurveKey + kCurveShortNonce;
  if (hello.size() != kBeforeBox + kCurveMac + 64) return std::nullopt;
  if (hello.substr(0, 2) != std::string_view("\1\0", 2)) return std::nullopt;
  short_client_ = hello.substr(kBefore, kCurveKey);
  const std::string nonce(hello.substr(kBefore + kCurveKey, kCurveShortNonce));
  if (!IsFresh(nonce) || !OpenCurveBox(hello.substr(kBeforeBox), "CurveZMQHELLO---" + nonce,
                                       short_client_, keys_.robot.secret_key)) {
    return std::nullopt;
  }
  const std::string long_nonce = RandomBytes(kCurveLongNonce);
  return long_nonce + CurveBox(short_public() + cookie_, "WELCOME-" + long_nonce, short_client_,
                               keys_.robot.secret_key);
}

// The cookie, nonce (8), box of C, vouch (nonce (16), box of C' and S), properties.
bool CurveConnection::Initiate(std::string_view initiate, std::string& properties) {
  if (initiate.size() < kCurveCookie + kCurveShortNonce) return false;
  if (sodium_memcmp(initiate.data(), cookie_.data(), kCurveCookie) != 0) return false;
  const std::string nonce(initiate.substr(kCurveCookie, kCurveShortNonce));
  const auto text = OpenCurveBox(initiate.substr(kCurveCookie + kCurveShortNonce),
                                 "CurveZMQINITIATE" + nonce, short_client_, short_secret());
  if (!IsFresh(nonce) || !text || text->size() < kCurveKey + kCurveVouch) return false;
  client_ = text->substr(0, kCurveKey);
  const std::string vouch = text->substr(kCurveKey, kCurveVouch);
  const auto vouched =
      OpenCurveBox(std::string_view(vouch).substr(kCurveLongNonce),
                   "VOUCH---" + vouch.substr(0, kCurveLongNonce), client_, short_secret());
  if (vouched != short_client_ + keys_.robot.public_key) return false;
  properties = text->substr(kCurveKey + kCurveVouch);
  return ShareKey(short_client_);
}

std::string CurveConnection::Ready(std::string_view properties) {
  const std::string nonce = NextNonce();
  return nonce + CurveBox(properties, "CurveZMQREADY---" + nonce, short_client_, short_secret());
}

}  // namespace coppice::zmtp
