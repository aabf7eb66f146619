// One connection of the supervisor page: HTTP until it asks for the WebSocket. Included by .cc
// files only; for the thread of the server.
#ifndef COPPICE_ROBOT_APP_INTERACTION_PAGE_VISIT_H_
#define COPPICE_ROBOT_APP_INTERACTION_PAGE_VISIT_H_

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include "bt_core/live/web_files.h"
#include "robot_app/interaction/page_http.h"
#include "robot_app/interaction/page_server.h"

namespace coppice::robot {

class PageVisit;

/// What the connections have in common.
struct PageHall {
  PageHall(const PageServerOptions& options, PageAccess& page_access, const Clock& page_clock)
      : access(page_access), clock(page_clock), files(options.folder), is_https(options.is_https) {}

  void Put(PageEvent event) {
    const std::lock_guard<std::mutex> lock(mutex);
    events.push_back(std::move(event));
  }

  PageAccess& access;
  const Clock& clock;
  const WebFiles files;
  const bool is_https;
  std::set<PageVisit*> visits;                                  // the server's thread only
  std::map<std::uint64_t, std::shared_ptr<PageVisit>> clients;  // the same
  std::uint64_t clients_so_far = 0;                             // the same

  std::mutex mutex;  // for the rest
  std::deque<PageEvent> events;
};

class PageVisit : public std::enable_shared_from_this<PageVisit> {
 public:
  PageVisit(boost::asio::ip::tcp::socket socket, PageHall& hall);
  ~PageVisit() { hall_.visits.erase(this); }
  PageVisit(const PageVisit&) = delete;
  PageVisit& operator=(const PageVisit&) = delete;

  void ReadRequest();
  void Send(const std::string& key, std::shared_ptr<const std::string> message, bool is_binary);
  /// Ends at once.
  void End();

 private:
  using Body = boost::beast::http::string_body;
  struct Message {
    std::string key;
    std::shared_ptr<const std::string> bytes;
    bool is_binary = false;
  };

  std::string Field(boost::beast::http::field field) const;
  bool IsFromOwnPage() const;
  void OnRequest();
  void OnPost();
  void LogIn();
  void Reply(boost::beast::http::status status, const std::string& type, std::string body,
             const std::string& cookie = {});
  void OnUpgrade();
  void Begin();
  void ReadMessage();
  void OnMessage();
  void WriteNext();

  PageHall& hall_;
  boost::beast::flat_buffer buffer_;
  boost::beast::tcp_stream stream_;
  std::optional<boost::beast::http::request_parser<Body>> parser_;
  boost::beast::http::request<Body> request_;

  std::optional<boost::beast::websocket::stream<boost::beast::tcp_stream>> socket_;
  std::uint64_t client_ = 0;
  std::string session_;
  PagePass pass_;
  RateLimit limit_{PageServer::kMostMessagesPerSecond};
  std::deque<Message> waiting_;
  std::optional<Message> on_the_way_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_INTERACTION_PAGE_VISIT_H_
