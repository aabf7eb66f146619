// One port for the supervisor page: its files and the log-in over HTTP, all else over a WebSocket
// (RFC 6455).
//
//   PageServer server(options, access, clock);
//   for (PageEvent event; server.Receive(event);) ...;
//   server.Send(client, text);
//
// It has a thread of its own, in which it reads what strangers send. A page is let in with the
// session cookie of its log-in and only from its own origin; who sends too much is thrown out, and
// who logs out or whose session is over within a second. A
// client that reads too slowly gets the newest of each kind of message and no past ones.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_SERVER_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_SERVER_H_

#include <cstdint>
#include <memory>
#include <string>

#include "bt_core/base/clock.h"
#include "robot_app/assistance/page/page_access.h"

namespace coppice::robot::assistance {

struct PageServerOptions {
  std::string address = "127.0.0.1";  ///< as LocalAddress (bt_core/live/web/local_address.h)
  std::uint16_t port = 0;             ///< 0 takes a free one
  std::string folder;                 ///< of the page's files
  bool is_https = false;              ///< supervisors come by https, through a proxy
};

/// Something that a page has done.
struct PageEvent {
  enum class Kind : std::uint8_t { kJoined, kText, kLeft };
  Kind kind = Kind::kJoined;
  std::uint64_t client = 0;  ///< not 0; never used again
  PagePass pass;
  std::string text;  ///< of kText
};

class PageServer {
 public:
  static constexpr std::size_t kMostConnections = 256;
  /// WebSockets of one session: tabs, and one that the network has not told of yet.
  static constexpr std::size_t kMostOfASession = 4;
  static constexpr std::size_t kMostHeaderBytes = 8 << 10;
  static constexpr std::size_t kMostBodyBytes = 1 << 10;
  static constexpr std::size_t kMostMessageBytes = 4 << 10;
  static constexpr int kMostMessagesPerSecond = 60;
  /// Messages of different kinds that may wait for a client.
  static constexpr std::size_t kMostWaiting = 64;

  /// Listens when it returns. Throws std::runtime_error, with a text for people, if the port cannot
  /// be had. `access` and `clock` must live longer.
  PageServer(const PageServerOptions& options, PageAccess& access, const Clock& clock);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  std::uint16_t port() const;

  /// Any thread. False if nothing has happened.
  bool Receive(PageEvent& event);

  /// Any thread; never waits. A message with the same `key` that has not gone out yet is replaced;
  /// with the key "" none is. A client that has gone is no error.
  void Send(std::uint64_t client, const std::string& key,
            std::shared_ptr<const std::string> message, bool is_binary = false);

 private:
  class Loop;
  std::unique_ptr<Loop> loop_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_SERVER_H_
