#include "bt_core/live/zmtp/zmtp_curve_session.h"

#include <sodium.h>

namespace coppice::zmtp {
namespace {

static_assert(kCurveKey == crypto_box_PUBLICKEYBYTES && kCurveMac == crypto_box_MACBYTES);

constexpr std::string_view kMessage = "\7MESSAGE";
constexpr std::size_t kBeforeBox = kMessage.size() + kCurveShortNonce;
static_assert(CurveSession::kOverhead == kBeforeBox + kCurveMac + 1);

using Byte = unsigned char;
const Byte* Bytes(std::string_view text) { return reinterpret_cast<const Byte*>(text.data()); }
Byte* Bytes(std::string& text) { return reinterpret_cast<Byte*>(text.data()); }

std::string Nonce(std::string_view name, std::string_view rest) {
  return std::string(name) += rest;
}

}  // namespace

std::string RandomBytes(std::size_t size) {
  std::string bytes(size, '\0');
  randombytes_buf(bytes.data(), size);
  return bytes;
}

std::string CurveBox(std::string_view text, const std::string& nonce, const std::string& public_key,
                     const std::string& secret_key) {
  std::string box(kCurveMac + text.size(), '\0');
  const int result = crypto_box_easy(Bytes(box), Bytes(text), text.size(), Bytes(nonce),
                                     Bytes(public_key), Bytes(secret_key));
  return result == 0 ? box : std::string();
}

std::optional<std::string> OpenCurveBox(std::string_view box, const std::string& nonce,
                                        std::string_view public_key,
                                        const std::string& secret_key) {
  if (box.size() < kCurveMac) return std::nullopt;
  std::string text(box.size() - kCurveMac, '\0');
  if (crypto_box_open_easy(Bytes(text), Bytes(box), box.size(), Bytes(nonce), Bytes(public_key),
                           Bytes(secret_key)) != 0) {
    return std::nullopt;
  }
  return text;
}

CurveSession::CurveSession(std::string_view own_messages, std::string_view messages_of_other)
    : own_messages_(own_messages),
      messages_of_other_(messages_of_other),
      short_public_(kCurveKey, '\0'),
      short_secret_(kCurveKey, '\0'),
      shared_(RandomBytes(crypto_box_BEFORENMBYTES)) {  // nobody's, until there is one
  crypto_box_keypair(Bytes(short_public_), Bytes(short_secret_));
}

CurveSession::~CurveSession() {
  sodium_memzero(short_secret_.data(), short_secret_.size());
  sodium_memzero(shared_.data(), shared_.size());
}

bool CurveSession::ShareKey(const std::string& short_public_of_other) {
  return crypto_box_beforenm(Bytes(shared_), Bytes(short_public_of_other), Bytes(short_secret_)) ==
         0;
}

std::string CurveSession::NextNonce() {
  ++nonce_;
  std::string bytes;
  for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(nonce_ >> shift & 0xff);
  return bytes;
}

bool CurveSession::IsFresh(std::string_view nonce) {
  std::uint64_t number = 0;
  for (const char byte : nonce) number = number << 8 | static_cast<Byte>(byte);
  if (number <= nonce_of_other_) return false;
  nonce_of_other_ = number;
  return true;
}

std::string CurveSession::Seal(std::uint8_t flags, std::string_view body) {
  const std::string nonce = NextNonce();
  std::string text(1, static_cast<char>(flags));
  text += body;
  std::string box(kCurveMac + text.size(), '\0');
  crypto_box_easy_afternm(Bytes(box), Bytes(text), text.size(), Bytes(Nonce(own_messages_, nonce)),
                          Bytes(shared_));
  return std::string(kMessage) + nonce + box;
}

bool CurveSession::Open(std::string& message, std::uint8_t& flags) {
  if (message.size() < kOverhead || message.compare(0, kMessage.size(), kMessage) != 0) {
    return false;
  }
  const std::string nonce = message.substr(kMessage.size(), kCurveShortNonce);
  Byte* const box = Bytes(message) + kBeforeBox;
  if (crypto_box_open_easy_afternm(box, box, message.size() - kBeforeBox,
                                   Bytes(Nonce(messages_of_other_, nonce)), Bytes(shared_)) != 0 ||
      !IsFresh(nonce)) {
    return false;
  }
  flags = static_cast<std::uint8_t>(message[kBeforeBox]);
  message.resize(message.size() - kCurveMac);
  message.erase(0, kBeforeBox + 1);
  return true;
}

}  // namespace coppice::zmtp
