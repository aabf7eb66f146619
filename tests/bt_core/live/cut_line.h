// A line between client and robot that can be cut: hands bytes on between a port of its own and
// another one.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_CUT_LINE_H_
#define COPPICE_TESTS_BT_CORE_LIVE_CUT_LINE_H_

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace coppice {

class CutLine {
 public:
  explicit CutLine(std::uint16_t to) : to_(to), listener_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address = Local(0);
    socklen_t size = sizeof(address);
    if (bind(listener_, Generic(address), size) != 0 || listen(listener_, 8) != 0 ||
        getsockname(listener_, Generic(address), &size) != 0) {
      throw std::runtime_error("no port for a line");
    }
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { Run(); });
  }
  ~CutLine() {
    stop_ = true;
    Ring();
    thread_.join();
    close(listener_);
    close(bell_);
  }
  CutLine(const CutLine&) = delete;
  CutLine& operator=(const CutLine&) = delete;

  std::string endpoint() const { return "127.0.0.1:" + std::to_string(port_); }

  /// Closes all connections; no new ones are made until Mend.
  void Cut() {
    is_cut_ = true;
    Ring();
  }
  void Mend() {
    is_cut_ = false;
    Ring();
  }

 private:
  struct Pair {
    int near;
    int far;
  };

  static sockaddr_in Local(std::uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
  }
  static sockaddr* Generic(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

  void Ring() {
    const std::uint64_t one = 1;
    if (write(bell_, &one, sizeof(one)) < 0) return;
  }

  void Run() {
    while (!stop_) {
      std::vector<pollfd> items = {{bell_, POLLIN, 0}, {listener_, POLLIN, 0}};
      for (const Pair& pair : pairs_) {
        items.push_back({pair.near, POLLIN, 0});
        items.push_back({pair.far, POLLIN, 0});
      }
      poll(items.data(), items.size(), -1);
      std::uint64_t rings = 0;
      if (items[0].revents && read(bell_, &rings, sizeof(rings)) < 0) return;
      std::vector<Pair> open;
      for (std::size_t i = 0; i < pairs_.size(); ++i) {
        const Pair pair = pairs_[i];
        const bool goes_on = !is_cut_ && (!items[2 + 2 * i].revents || Copy(pair.near, pair.far)) &&
                             (!items[3 + 2 * i].revents || Copy(pair.far, pair.near));
        if (goes_on) {
          open.push_back(pair);
        } else {
          Close(pair);
        }
      }
      pairs_ = open;
      if (items[1].revents) Accept();
    }
    for (const Pair& pair : pairs_) Close(pair);
  }

  static void Close(const Pair& pair) {
    close(pair.near);
    close(pair.far);
  }

  static bool Copy(int from, int to) {
    char bytes[65536];
    const ssize_t count = recv(from, bytes, sizeof(bytes), 0);
    return count > 0 && send(to, bytes, static_cast<std::size_t>(count), MSG_NOSIGNAL) == count;
  }

  void Accept() {
    const int near = accept(listener_, nullptr, nullptr);
    if (near < 0) return;
    const int far = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = Local(to_);
    if (is_cut_ || connect(far, Generic(address), sizeof(address)) != 0) {
      Close({near, far});
      return;
    }
    pairs_.push_back({near, far});
  }

  const std::uint16_t to_;
  const int listener_;
  const int bell_ = eventfd(0, 0);
  std::uint16_t port_ = 0;
  std::atomic<bool> stop_{false};
  std::atomic<bool> is_cut_{false};
  std::vector<Pair> pairs_;
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_CUT_LINE_H_
