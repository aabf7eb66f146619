// One connection of a browser: HTTP until it asks for a WebSocket. Serves the files of a page;
// subclasses say what else they take. Included by .cc files only; the port's thread only. Alive
// while something is awaited.
#ifndef COPPICE_BT_CORE_LIVE_WEB_WEB_CONNECTION_H_
#define COPPICE_BT_CORE_LIVE_WEB_WEB_CONNECTION_H_

#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/live/web/web_files.h"
#include "bt_core/live/web/web_port.h"

namespace coppice {

/// Of all connections of a port.
struct WebConnectionOptions {
  std::size_t header_bytes = 8 << 10;                       ///< who sends more is hung up on
  std::size_t body_bytes = 0;                               ///< the same
  std::vector<std::pair<std::string, std::string>> fields;  ///< of the header of every answer
  std::string not_found;                                    ///< for people; ends with a new line
};

class WebConnection : public PortConnection, public std::enable_shared_from_this<WebConnection> {
 public:
  /// `files` and `options` must live longer.
  WebConnection(WebPort::Socket socket, WebPort& port, const WebFiles& files,
                const WebConnectionOptions& options);

  void Start() override { ReadRequest(); }
  /// A connection that has not asked for a WebSocket is closed at once.
  void Finish() override { stream_.close(); }
  void HangUp() override { stream_.close(); }
  /// Subclasses say who gets a WebSocket, and what claim that gives.
  Claim claim() const override { return Claim::kStranger; }

 protected:
  using Status = boost::beast::http::status;
  using Fields = std::vector<std::pair<std::string, std::string>>;

  /// request() asks for a WebSocket; who does not take it answers.
  virtual void OnUpgrade() = 0;
  /// request() is a GET or HEAD: answers with a file of the page.
  virtual void OnGet();
  /// request() is a POST.
  virtual void OnPost();

  const boost::beast::http::request<boost::beast::http::string_body>& request() const {
    return request_;
  }
  /// Of the request's header; empty if it is not there.
  std::string_view Field(boost::beast::http::field field) const;

  /// Answers the request, and reads the next one. `fields` are added to the header.
  void Reply(Status status, std::string body, const Fields& fields = {});
  /// The same; the connection ends with the answer.
  void Refuse(Status status, std::string body);
  void NotFound() { Reply(Status::not_found, options_.not_found); }

  boost::beast::flat_buffer buffer_;  ///< empty when OnUpgrade is called
  boost::beast::tcp_stream stream_;   ///< until it is moved into the WebSocket

 private:
  void ReadRequest();
  void OnRequest();
  template <class Body>
  std::shared_ptr<boost::beast::http::response<Body>> Begin(Status status, const char* type) const;
  template <class Body>
  void Send(std::shared_ptr<boost::beast::http::response<Body>> answer);

  const WebFiles& files_;
  const WebConnectionOptions& options_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::string_body>> parser_;
  boost::beast::http::request<boost::beast::http::string_body> request_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_WEB_CONNECTION_H_
