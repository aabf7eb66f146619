#include "bt_core/live/zmtp/zmtp_curve.h"

#include <sodium.h>

#include <stdexcept>

namespace coppice::zmtp {
namespace {

constexpr std::size_t kKey = crypto_box_PUBLICKEYBYTES;
constexpr std::size_t kMac = crypto_box_MACBYTES;
constexpr std::size_t kShortNonce = 8;
constexpr std::size_t kLongNonce = 16;
constexpr std::size_t kCookie = 96;
constexpr std::size_t kVouch = kLongNonce + kMac + 2 * kKey;
constexpr std::string_view kMessage = "\7MESSAGE";

using Byte = unsigned char;
const Byte* Bytes(std::string_view text) { return reinterpret_cast<const Byte*>(text.data()); }
Byte* Bytes(std::string& text) { return reinterpret_cast<Byte*>(text.data()); }

std::string Random(std::size_t size) {
  std::string bytes(size, '\0');
  randombytes_buf(bytes.data(), size);
  return bytes;
}

std::string Nonce(std::string_view prefix, std::string_view rest) {
  return std::string(prefix) += rest;
}

std::string ShortNonce(std::uint64_t number) {
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

std::string Box(std::string_view text, const std::string& nonce, const std::string& public_key,
                const std::string& secret_key) {
  std::string box(kMac + text.size(), '\0');
  if (crypto_box_easy(Bytes(box), Bytes(text), text.size(), Bytes(nonce), Bytes(public_key),
                      Bytes(secret_key)) != 0) {
    throw std::runtime_error("a key that nothing can be encrypted for");
  }
  return box;
}

std::optional<std::string> OpenBox(std::string_view box, const std::string& nonce,
                                   std::string_view public_key, const std::string& secret_key) {
  if (box.size() < kMac) return std::nullopt;
  std::string text(box.size() - kMac, '\0');
  if (crypto_box_open_easy(Bytes(text), Bytes(box), box.size(), Bytes(nonce), Bytes(public_key),
                           Bytes(secret_key)) != 0) {
    return std::nullopt;
  }
  return text;
}

}  // namespace

CurveConnection::CurveConnection(const RobotKeys& keys)
    : keys_(keys), short_public_(kKey, '\0'), short_secret_(kKey, '\0'), cookie_(Random(kCookie)) {
  crypto_box_keypair(Bytes(short_public_), Bytes(short_secret_));
}

CurveConnection::~CurveConnection() {
  sodium_memzero(short_secret_.data(), short_secret_.size());
  sodium_memzero(shared_.data(), shared_.size());
}

// Nonces of the client go up: nothing can be sent again by others.
bool CurveConnection::IsFresh(std::string_view nonce) {
  std::uint64_t number = 0;
  for (const char byte : nonce) number = number << 8 | static_cast<Byte>(byte);
  if (number <= client_nonce_) return false;
  client_nonce_ = number;
  return true;
}

// Version (2), zeros (72), C', nonce (8), box of 64 zeros.
std::optional<std::string> CurveConnection::Welcome(std::string_view hello) {
  constexpr std::size_t kBefore = 2 + 72;
  if (hello.size() != kBefore + kKey + kShortNonce + kMac + 64) return std::nullopt;
  if (hello.substr(0, 2) != std::string_view("\1\0", 2)) return std::nullopt;
  short_client_ = hello.substr(kBefore, kKey);
  const std::string_view nonce = hello.substr(kBefore + kKey, kShortNonce);
  if (!IsFresh(nonce) ||
      !OpenBox(hello.substr(kBefore + kKey + kShortNonce), Nonce("CurveZMQHELLO---", nonce),
               short_client_, keys_.robot.secret_key)) {
    return std::nullopt;
  }
  const std::string long_nonce = Random(kLongNonce);
  return long_nonce + Box(short_public_ + cookie_, Nonce("WELCOME-", long_nonce), short_client_,
                          keys_.robot.secret_key);
}

// The cookie, nonce (8), box of C, vouch (nonce (16), box of C' and S), properties.
bool CurveConnection::Initiate(std::string_view initiate, std::string& properties) {
  if (initiate.size() < kCookie + kShortNonce) return false;
  if (sodium_memcmp(initiate.data(), cookie_.data(), kCookie) != 0) return false;
  const std::string_view nonce = initiate.substr(kCookie, kShortNonce);
  const auto text = OpenBox(initiate.substr(kCookie + kShortNonce),
                            Nonce("CurveZMQINITIATE", nonce), short_client_, short_secret_);
  if (!IsFresh(nonce) || !text || text->size() < kKey + kVouch) return false;
  client_ = text->substr(0, kKey);
  const std::string vouch = text->substr(kKey, kVouch);
  const auto vouched =
      OpenBox(std::string_view(vouch).substr(kLongNonce),
              Nonce("VOUCH---", vouch.substr(0, kLongNonce)), client_, short_secret_);
  if (vouched != short_client_ + keys_.robot.public_key) return false;
  properties = text->substr(kKey + kVouch);
  shared_.resize(crypto_box_BEFORENMBYTES);
  return crypto_box_beforenm(Bytes(shared_), Bytes(short_client_), Bytes(short_secret_)) == 0;
}

std::string CurveConnection::Ready(std::string_view properties) {
  const std::string nonce = ShortNonce(++nonce_);
  return nonce + Box(properties, Nonce("CurveZMQREADY---", nonce), short_client_, short_secret_);
}

std::string CurveConnection::Seal(std::uint8_t flags, std::string_view body) {
  const std::string nonce = ShortNonce(++nonce_);
  std::string text(1, static_cast<char>(flags));
  text += body;
  std::string box(kMac + text.size(), '\0');
  crypto_box_easy_afternm(Bytes(box), Bytes(text), text.size(),
                          Bytes(Nonce("CurveZMQMESSAGES", nonce)), Bytes(shared_));
  return std::string(kMessage) + nonce + box;
}

std::optional<std::string> CurveConnection::Open(std::string_view message, std::uint8_t& flags) {
  constexpr std::size_t kBefore = kMessage.size() + kShortNonce;
  if (message.size() < kBefore + kMac + 1) return std::nullopt;
  if (message.substr(0, kMessage.size()) != kMessage) return std::nullopt;
  const std::string_view nonce = message.substr(kMessage.size(), kShortNonce);
  const std::string_view box = message.substr(kBefore);
  std::string text(box.size() - kMac, '\0');
  if (crypto_box_open_easy_afternm(Bytes(text), Bytes(box), box.size(),
                                   Bytes(Nonce("CurveZMQMESSAGEC", nonce)), Bytes(shared_)) != 0) {
    return std::nullopt;
  }
  if (!IsFresh(nonce)) return std::nullopt;
  flags = static_cast<std::uint8_t>(text[0]);
  text.erase(0, 1);
  return text;
}

}  // namespace coppice::zmtp
