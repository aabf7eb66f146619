// The client's side of CURVE, ZeroMQ's encryption (RFC 26): what a fuzzer says behind it could not
// be read without.
#ifndef COPPICE_TESTS_FUZZ_CURVE_CLIENT_H_
#define COPPICE_TESTS_FUZZ_CURVE_CLIENT_H_

#include <cstdint>
#include <string>
#include <string_view>

#include "bt_core/live/server/token_keys.h"

namespace coppice::fuzz {

class CurveClient {
 public:
  explicit CurveClient(WatcherKeys keys);

  // Commands and messages with their names.
  std::string Hello();
  /// The answer to Hello, without its name; false if it is none.
  bool TakeWelcome(std::string_view welcome);
  std::string Initiate(std::string_view properties);
  std::string Message(std::uint8_t flags, std::string_view body);

 private:
  std::string NextNonce();

  const WatcherKeys keys_;
  std::string short_public_;
  std::string short_secret_;
  std::string robot_;  // the robot's key of this connection
  std::string cookie_;
  std::uint64_t nonce_ = 0;
};

}  // namespace coppice::fuzz

#endif  // COPPICE_TESTS_FUZZ_CURVE_CLIENT_H_
