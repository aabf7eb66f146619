#include "tests/fuzz/curve_client.h"

#include <sodium.h>

#include <utility>

namespace coppice::fuzz {
namespace {

using namespace std::string_literals;  // NOLINT(google-build-using-namespace)

constexpr std::size_t kKey = crypto_box_PUBLICKEYBYTES;
constexpr std::size_t kMac = crypto_box_MACBYTES;
constexpr std::size_t kCookie = 96;
constexpr std::size_t kLongNonce = 16;

using Byte = unsigned char;
const Byte* Bytes(std::string_view text) { return reinterpret_cast<const Byte*>(text.data()); }
Byte* Bytes(std::string& text) { return reinterpret_cast<Byte*>(text.data()); }

// Empty for a key that nothing can be encrypted for.
std::string Box(std::string_view text, const std::string& nonce, const std::string& public_key,
                const std::string& secret_key) {
  std::string box(kMac + text.size(), '\0');
  const int result = crypto_box_easy(Bytes(box), Bytes(text), text.size(), Bytes(nonce),
                                     Bytes(public_key), Bytes(secret_key));
  return result == 0 ? box : std::string();
}

}  // namespace

CurveClient::CurveClient(WatcherKeys keys)
    : keys_(std::move(keys)), short_public_(kKey, '\0'), short_secret_(kKey, '\0') {
  crypto_box_keypair(Bytes(short_public_), Bytes(short_secret_));
  robot_ = keys_.robot;  // until it has said another
  cookie_.resize(kCookie);
}

std::string CurveClient::NextNonce() {
  ++nonce_;
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(nonce_ >> shift & 0xff);
  return bytes;
}

std::string CurveClient::Hello() {
  const std::string nonce = NextNonce();
  return "\5HELLO\1\0"s + std::string(72, '\0') + short_public_ + nonce +
         Box(std::string(64, '\0'), "CurveZMQHELLO---" + nonce, keys_.robot, short_secret_);
}

bool CurveClient::TakeWelcome(std::string_view welcome) {
  std::string text(kKey + kCookie, '\0');
  if (welcome.size() != kLongNonce + kMac + text.size()) return false;
  const std::string nonce = "WELCOME-" + std::string(welcome.substr(0, kLongNonce));
  const std::string_view box = welcome.substr(kLongNonce);
  if (crypto_box_open_easy(Bytes(text), Bytes(box), box.size(), Bytes(nonce), Bytes(keys_.robot),
                           Bytes(short_secret_)) != 0) {
    return false;
  }
  robot_ = text.substr(0, kKey);
  cookie_ = text.substr(kKey);
  return true;
}

std::string CurveClient::Initiate(std::string_view properties) {
  const std::string vouch_nonce(kLongNonce, 'v');
  const std::string vouch = vouch_nonce + Box(short_public_ + keys_.robot, "VOUCH---" + vouch_nonce,
                                              robot_, keys_.client.secret_key);
  const std::string nonce = NextNonce();
  const std::string text = keys_.client.public_key + vouch + std::string(properties);
  return "\10INITIATE" + cookie_ + nonce +
         Box(text, "CurveZMQINITIATE" + nonce, robot_, short_secret_);
}

std::string CurveClient::Message(std::uint8_t flags, std::string_view body) {
  const std::string nonce = NextNonce();
  const std::string text = std::string(1, static_cast<char>(flags)) += body;
  return "\7MESSAGE" + nonce + Box(text, "CurveZMQMESSAGEC" + nonce, robot_, short_secret_);
}

}  // namespace coppice::fuzz
