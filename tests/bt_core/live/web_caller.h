// The other end of a WebGateway for tests: a plain TCP socket, so that it can also say what no
// library for clients would. Waits for answers for at most half a minute.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_WEB_CALLER_H_
#define COPPICE_TESTS_BT_CORE_LIVE_WEB_CALLER_H_

#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace coppice {

class WebCaller {
 public:
  /// `from`: the last number of the address 127.0.0.* that it comes from.
  explicit WebCaller(std::uint16_t port, std::uint32_t from = 1)
      : port_(port), socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK - 1 + from);
    if (bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
      close(socket_);
      throw std::runtime_error("no such address");
    }
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{30, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
      close(socket_);
      throw std::runtime_error("nobody listens");
    }
  }
  ~WebCaller() { close(socket_); }
  WebCaller(const WebCaller&) = delete;
  WebCaller& operator=(const WebCaller&) = delete;

  void Say(const std::string& bytes) { ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }

  /// The header of the answer; empty if the connection is closed instead.
  std::string Ask(const std::string& bytes) {
    Say(bytes);
    std::string header;
    while (header.size() < 4 || header.substr(header.size() - 4) != "\r\n\r\n") {
      const std::string byte = Take(1);
      if (byte.empty()) return "";
      header += byte;
    }
    return header;
  }

  std::string Upgrade(const std::string& token) {
    return Ask("GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(port_) +
               "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
               "Sec-WebSocket-Protocol: coppice-live" +
               (token.empty() ? "" : ", token." + token) + "\r\n\r\n");
  }

  /// One binary message of less than 126 bytes, masked with zeros.
  void Send(const std::string& message) {
    Say(std::string("\x82") + static_cast<char>(0x80 + message.size()) + std::string(4, '\0') +
        message);
  }

  /// The payload of the next frame; empty if the connection is closed instead.
  std::string Read() {
    const std::string head = Take(2);
    if (head.size() < 2) return "";
    std::size_t size = static_cast<unsigned char>(head[1]);
    if (size < 126) return Take(size);
    const std::string bytes = Take(size == 126 ? 2 : 8);
    size = 0;
    for (const unsigned char byte : bytes) size = size << 8 | byte;
    return Take(size);
  }

  /// Says nothing more; what comes until the other end says nothing more either.
  std::string Rest() {
    shutdown(socket_, SHUT_WR);
    std::string all;
    for (std::string byte = Take(1); !byte.empty(); byte = Take(1)) all += byte;
    return all;
  }

 private:
  std::string Take(std::size_t size) {
    std::string bytes(size, '\0');
    const ssize_t count = recv(socket_, bytes.data(), size, MSG_WAITALL);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  const std::uint16_t port_;
  const int socket_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_WEB_CALLER_H_
