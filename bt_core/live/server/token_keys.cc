#include "bt_core/live/server/token_keys.h"

#include <sodium.h>

#include <array>
#include <new>
#include <stdexcept>

namespace coppice {
namespace {

constexpr std::string_view kReadPrefix = "read-";
constexpr std::size_t kReadSecretSize = 16;
constexpr std::size_t kWebTokenSize = 16;
constexpr std::size_t kKeySize = 32;
constexpr std::size_t kShortestToken = 16;
constexpr unsigned char kSalt[crypto_pwhash_SALTBYTES] = {'c', 'o', 'p', 'p', 'i', 'c', 'e', '-',
                                                          'l', 'i', 'v', 'e', '-', 'v', '1', 0};

const unsigned char* Bytes(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}
unsigned char* Bytes(std::string& text) { return reinterpret_cast<unsigned char*>(text.data()); }

void Begin() {
  if (sodium_init() < 0) throw std::runtime_error("libsodium cannot be used on this computer");
}

std::string Stretch(std::string_view token) {
  std::string seed(kKeySize, '\0');
  constexpr unsigned long long kPasses = 2;
  constexpr std::size_t kMemory = 64 << 20;
  if (crypto_pwhash(Bytes(seed), seed.size(), token.data(), token.size(), kSalt, kPasses, kMemory,
                    crypto_pwhash_ALG_ARGON2ID13) != 0) {
    throw std::bad_alloc();
  }
  return seed;
}

std::string Hash(std::string_view key, std::string_view text) {
  std::string hash(kKeySize, '\0');
  crypto_generichash(Bytes(hash), hash.size(), Bytes(text), text.size(),
                     key.empty() ? nullptr : Bytes(key), key.size());
  return hash;
}

CurveKeys KeysOfSecret(std::string secret) {
  std::string public_key(kKeySize, '\0');
  crypto_scalarmult_base(Bytes(public_key), Bytes(secret));
  return {std::move(public_key), std::move(secret)};
}

std::string ToHex(std::string_view bytes) {
  std::string hex(bytes.size() * 2 + 1, '\0');
  sodium_bin2hex(hex.data(), hex.size(), Bytes(bytes), bytes.size());
  hex.pop_back();
  return hex;
}

bool IsReadToken(std::string_view token) {
  return token.substr(0, kReadPrefix.size()) == kReadPrefix;
}

void CheckLength(std::string_view token) {
  if (token.size() >= kShortestToken) return;
  throw std::invalid_argument("live view: the token is shorter than " +
                              std::to_string(kShortestToken) +
                              " characters and could be guessed; make one with: openssl rand -hex "
                              "16");
}

WatcherKeys KeysOfReader(std::string_view token) {
  std::string bytes(kReadSecretSize + kKeySize, '\0');
  const std::string_view hex = token.substr(kReadPrefix.size());
  std::size_t size = 0;
  if (hex.size() != bytes.size() * 2 ||
      sodium_hex2bin(Bytes(bytes), bytes.size(), hex.data(), hex.size(), nullptr, &size, nullptr) !=
          0 ||
      size != bytes.size()) {
    throw std::invalid_argument(
        "live view: the read token is damaged; it is \"read-\" and 96 hexadecimal digits");
  }
  return {KeysOfSecret(Hash({}, std::string_view(bytes).substr(0, kReadSecretSize))),
          bytes.substr(kReadSecretSize)};
}

}  // namespace

RobotKeys KeysOfRobot(std::string_view control_token) {
  Begin();
  if (IsReadToken(control_token)) {
    throw std::invalid_argument(
        "live view: this is a token for readers; the robot needs the one that it came from");
  }
  CheckLength(control_token);
  const std::string seed = Stretch(control_token);
  const std::string read_secret = Hash(seed, "read").substr(0, kReadSecretSize);
  RobotKeys keys;
  keys.robot = KeysOfSecret(Hash(seed, "server"));
  keys.control_client = KeysOfSecret(Hash(seed, "control")).public_key;
  keys.read_client = KeysOfSecret(Hash({}, read_secret)).public_key;
  keys.read_token = std::string(kReadPrefix) + ToHex(read_secret + keys.robot.public_key);
  keys.web_control_token = ToHex(Hash(seed, "web").substr(0, kWebTokenSize));
  keys.web_read_token = ToHex(Hash(seed, "web-read").substr(0, kWebTokenSize));
  return keys;
}

WatcherKeys KeysOfWatcher(std::string_view token) {
  Begin();
  if (IsReadToken(token)) return KeysOfReader(token);
  CheckLength(token);
  const std::string seed = Stretch(token);
  return {KeysOfSecret(Hash(seed, "control")), KeysOfSecret(Hash(seed, "server")).public_key};
}

}  // namespace coppice
