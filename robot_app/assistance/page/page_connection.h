// One connection of the supervisor page: its files, the log-in, and the WebSocket. Included by .cc
// files only; for the thread of the server.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_CONNECTION_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_CONNECTION_H_

#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "bt_core/live/web/web_connection.h"
#include "robot_app/assistance/page/page_http.h"
#include "robot_app/assistance/page/page_server.h"
#include "robot_app/common/web/rate_limit.h"

namespace coppice::robot::assistance {

class PageConnection;

/// What the connections have in common.
struct PageSharedState {
  PageSharedState(const PageServerOptions& options, PageAccess& page_access,
                  const Clock& page_clock);

  void Put(PageEvent event) {
    const std::lock_guard<std::mutex> lock(mutex);
    events.push_back(std::move(event));
  }

  /// Ends the WebSockets of those who have logged out or whose time is over. The server's thread.
  void EndWithoutSession();
  /// Ends the oldest WebSockets of a session that has too many. The server's thread.
  void KeepFewOf(const std::string& session);

  PageAccess& access;
  const Clock& clock;
  const WebFiles files;
  const WebConnectionOptions options;
  const bool is_https;
  std::map<std::uint64_t, std::shared_ptr<PageConnection>> clients;  // the server's thread only
  std::uint64_t clients_so_far = 0;                                  // the same

  std::mutex mutex;  // for the rest
  std::deque<PageEvent> events;
};

class PageConnection : public WebConnection {
 public:
  PageConnection(WebPort::Socket socket, WebPort& port, PageSharedState& shared)
      : WebConnection(std::move(socket), port, shared.files, shared.options), shared_(shared) {}

  void Send(const std::string& key, std::shared_ptr<const std::string> message, bool is_binary);
  /// The secret with which it came.
  const std::string& session() const { return session_; }
  /// Ends at once.
  void End();
  void Finish() override { End(); }
  void HangUp() override { End(); }
  Claim claim() const override;

 private:
  struct Message {
    std::string key;
    std::shared_ptr<const std::string> bytes;
    bool is_binary = false;
  };

  std::shared_ptr<PageConnection> Self() {
    return std::static_pointer_cast<PageConnection>(shared_from_this());
  }
  bool IsFromOwnPage() const;
  void OnPost() override;
  void LogIn();
  void GiveSession(const std::string& session);
  void OnUpgrade() override;
  void Begin();
  void ReadMessage();
  void OnMessage();
  void WriteNext();

  PageSharedState& shared_;
  std::optional<boost::beast::websocket::stream<boost::beast::tcp_stream>> socket_;
  std::uint64_t client_ = 0;
  std::string session_;
  PagePass pass_;
  RateLimit limit_{PageServer::kMostMessagesPerSecond};
  std::deque<Message> waiting_;
  std::optional<Message> on_the_way_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_PAGE_CONNECTION_H_
