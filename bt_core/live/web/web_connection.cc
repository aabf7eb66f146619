#include "bt_core/live/web/web_connection.h"

#include <boost/beast/websocket/rfc6455.hpp>

namespace coppice {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using beast::error_code;

constexpr auto kPatience = std::chrono::seconds(20);
constexpr const char* kText = "text/plain; charset=utf-8";

std::string_view View(beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

WebConnection::WebConnection(WebPort::Socket socket, WebPort& port, const WebFiles& files,
                             const WebConnectionOptions& options)
    : PortConnection(port), stream_(std::move(socket)), files_(files), options_(options) {
  error_code error;
  stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true), error);
}

void WebConnection::ReadRequest() {
  parser_.emplace();
  parser_->header_limit(options_.header_bytes);
  parser_->body_limit(options_.body_bytes);
  // The limits of the parser are those of header and body; how long the size of a chunk is, or what
  // comes behind the last one, is not limited by it.
  buffer_.max_size(options_.header_bytes);
  stream_.expires_after(kPatience);
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (!error) self->OnRequest();
                   });
}

std::string_view WebConnection::Field(http::field field) const { return View(request_[field]); }

void WebConnection::OnRequest() {
  Hear();
  request_ = parser_->release();
  if (beast::websocket::is_upgrade(request_)) {
    buffer_ = {};
    return OnUpgrade();
  }
  switch (request_.method()) {
    case http::verb::get:
    case http::verb::head:
      return OnGet();
    case http::verb::post:
      return OnPost();
    default:
      Reply(Status::method_not_allowed, "this method is not served here\n");
  }
}

// The file is read as it goes out: who does not take it costs no copy of it.
void WebConnection::OnGet() {
  const bool accepts_gzip = AcceptsGzip(Field(http::field::accept_encoding));
  const std::optional<WebFile> file = files_.Find(View(request_.target()), accepts_gzip);
  http::file_body::value_type content;
  error_code error;
  if (file) content.open(file->path.c_str(), beast::file_mode::scan, error);
  if (!file || error) return NotFound();
  const auto describe = [&](auto& answer) {
    answer.set(http::field::vary, "Accept-Encoding");
    if (file->is_gzipped) answer.set(http::field::content_encoding, "gzip");
    answer.content_length(content.size());
  };
  if (request_.method() == http::verb::head) {
    const auto answer = Begin<http::empty_body>(Status::ok, file->type);
    describe(*answer);
    return Send(answer);
  }
  const auto answer = Begin<http::file_body>(Status::ok, file->type);
  describe(*answer);
  answer->body() = std::move(content);
  Send(answer);
}

void WebConnection::OnPost() { Reply(Status::method_not_allowed, "only GET is served here\n"); }

void WebConnection::Reply(Status status, std::string body, const Fields& fields) {
  const auto answer = Begin<http::string_body>(status, kText);
  for (const auto& [name, value] : fields) answer->set(name, value);
  if (status != Status::no_content) answer->content_length(body.size());
  if (request_.method() != http::verb::head) answer->body() = std::move(body);
  Send(answer);
}

void WebConnection::Refuse(Status status, std::string body) {
  request_.keep_alive(false);
  Reply(status, std::move(body));
}

template <class Body>
std::shared_ptr<http::response<Body>> WebConnection::Begin(Status status, const char* type) const {
  auto answer = std::make_shared<http::response<Body>>(status, request_.version());
  if (status != Status::no_content) answer->set(http::field::content_type, type);
  answer->set(http::field::x_frame_options, "DENY");
  answer->set("X-Content-Type-Options", "nosniff");
  for (const auto& [name, value] : options_.fields) answer->set(name, value);
  answer->keep_alive(request_.keep_alive());
  return answer;
}

template <class Body>
void WebConnection::Send(std::shared_ptr<http::response<Body>> answer) {
  stream_.expires_after(kPatience);
  http::async_write(stream_, *answer,
                    [self = shared_from_this(), answer](error_code error, std::size_t) {
                      if (!error && answer->keep_alive()) self->ReadRequest();
                    });
}

}  // namespace coppice
