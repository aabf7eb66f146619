#include "bt_core/live/zmtp/zmtp_curve_client.h"

namespace coppice::zmtp {

CurveClient::CurveClient(const WatcherKeys& keys)
    : CurveSession("CurveZMQMESSAGEC", "CurveZMQMESSAGES"),
      keys_(keys),
      short_robot_(kCurveKey, '\0') {}

// Version (2), zeros (72), C', nonce (8), box of 64 zeros.
std::string CurveClient::Hello() {
  const std::string nonce = NextNonce();
  return std::string("\1\0", 2) + std::string(72, '\0') + short_public() + nonce +
         CurveBox(std::string(64, '\0'), "CurveZMQHELLO---" + nonce, keys_.robot, short_secret());
}

// Nonce (16), box of S' and the cookie.
bool CurveClient::Welcome(std::string_view welcome) {
  if (welcome.size() < kCurveLongNonce) return false;
  const std::string nonce(welcome.substr(0, kCurveLongNonce));
  const auto text = OpenCurveBox(welcome.substr(kCurveLongNonce), "WELCOME-" + nonce, keys_.robot,
                                 short_secret());
  if (!text || text->size() != kCurveKey + kCurveCookie) return false;
  short_robot_ = text->substr(0, kCurveKey);
  cookie_ = text->substr(kCurveKey);
  is_welcome_ = ShareKey(short_robot_);
  return is_welcome_;
}

// The cookie, nonce (8), box of C, vouch (nonce (16), box of C' and S), properties.
std::string CurveClient::Initiate(std::string_view properties) {
  const std::string vouch_nonce = RandomBytes(kCurveLongNonce);
  const std::string vouch = CurveBox(short_public() + keys_.robot, "VOUCH---" + vouch_nonce,
                                     short_robot_, keys_.client.secret_key);
  std::string text = keys_.client.public_key + vouch_nonce + vouch;
  text += properties;
  const std::string nonce = NextNonce();
  return cookie_ + nonce + CurveBox(text, "CurveZMQINITIATE" + nonce, short_robot_, short_secret());
}

// Nonce (8), box of the properties.
bool CurveClient::Ready(std::string_view ready, std::string& properties) {
  if (ready.size() < kCurveShortNonce) return false;
  const std::string nonce(ready.substr(0, kCurveShortNonce));
  auto text = OpenCurveBox(ready.substr(kCurveShortNonce), "CurveZMQREADY---" + nonce, short_robot_,
                           short_secret());
  if (!text || !IsFresh(nonce)) return false;
  properties = *std::move(text);
  return true;
}

}  // namespace coppice::zmtp
