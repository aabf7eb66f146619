// The keys that follow from the token of a live view, so that people handle one text and the
// connection is encrypted and authenticated on both sides (CURVE of ZeroMQ).
//
// Whoever has the control token can compute everything; the read token holds what a reader needs
// and no more: it can neither control nor pretend to be the robot. docs/live.md says how.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_TOKEN_KEYS_H_
#define COPPICE_BT_CORE_LIVE_SERVER_TOKEN_KEYS_H_

#include <string>
#include <string_view>

namespace coppice {

/// Where programs find their token: an argument could be read by every user of the computer.
inline constexpr const char* kTokenVariable = "COPPICE_LIVE_TOKEN";

/// 32 bytes each, as ZeroMQ takes them.
struct CurveKeys {
  std::string public_key;
  std::string secret_key;
};

struct RobotKeys {
  CurveKeys robot;
  std::string control_client;  ///< public keys of those who may connect
  std::string read_client;
  std::string read_token;         ///< for people who only watch
  std::string web_control_token;  ///< for browsers (web_access.h)
  std::string web_read_token;
};

struct WatcherKeys {
  CurveKeys client;
  std::string robot;  ///< its public key
};

/// For the program that runs the tree. Takes a tenth of a second and 64 MiB: guessing tokens shall
/// be dear. Throws std::invalid_argument, with a text for people, if the token is too short or a
/// read token.
RobotKeys KeysOfRobot(std::string_view control_token);

/// For a client, with either token. Throws as KeysOfRobot does.
WatcherKeys KeysOfWatcher(std::string_view token);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_TOKEN_KEYS_H_
