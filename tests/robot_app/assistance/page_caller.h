// A browser's side of the supervisor page for tests, down to the bytes; waits for at most half a
// minute.
#ifndef COPPICE_TESTS_ROBOT_APP_ASSISTANCE_PAGE_CALLER_H_
#define COPPICE_TESTS_ROBOT_APP_ASSISTANCE_PAGE_CALLER_H_

#include <cstdint>
#include <string>

#include "tests/bt_core/live/web_caller.h"

namespace coppice::robot::assistance {

class PageCaller : public WebCaller {
 public:
  explicit PageCaller(std::uint16_t port)
      : WebCaller(port), host_("localhost:" + std::to_string(port)) {}

  /// The whole answer, its body included.
  std::string Request(const std::string& request) {
    Say(request);
    return Rest();
  }
  std::string Get(const std::string& target) {
    return Request("GET " + target + " HTTP/1.1\r\nHost: " + host_ + "\r\n\r\n");
  }
  std::string Post(const std::string& target, const std::string& body, const std::string& origin,
                   const std::string& cookie = {}) {
    return Request("POST " + target + " HTTP/1.1\r\nHost: " + host_ + "\r\nOrigin: " + origin +
                   "\r\nCookie: " + cookie + "\r\nContent-Length: " + std::to_string(body.size()) +
                   "\r\n\r\n" + body);
  }
  std::string own_origin() const { return "http://" + host_; }

  /// The header of the answer to the wish for a WebSocket.
  std::string Upgrade(const std::string& cookie, const std::string& origin,
                      const std::string& target = "/live") {
    return Ask("GET " + target + " HTTP/1.1\r\nHost: " + host_ +
               "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nOrigin: " +
               origin + "\r\nCookie: " + cookie + "\r\n\r\n");
  }

  /// A text message of less than 126 bytes.
  void SendText(const std::string& message) {
    Say(std::string("\x81") + static_cast<char>(0x80 + message.size()) + std::string(4, '\0') +
        message);
  }

 private:
  const std::string host_;
};

/// "coppice_session=..." of an answer.
inline std::string CookieOf(const std::string& answer) {
  const std::size_t begin = answer.find("coppice_session=");
  return begin == std::string::npos ? "" : answer.substr(begin, answer.find(';', begin) - begin);
}

}  // namespace coppice::robot::assistance

#endif  // COPPICE_TESTS_ROBOT_APP_ASSISTANCE_PAGE_CALLER_H_
