#include "robot_app/interaction/page_visit.h"

#include <algorithm>
#include <utility>

#include "bt_core/live/web_access.h"

namespace coppice::robot {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

constexpr auto kHttpPatience = std::chrono::seconds(20);
constexpr const char* kText = "text/plain; charset=utf-8";

std::string_view View(beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

PageVisit::PageVisit(asio::ip::tcp::socket socket, PageHall& hall)
    : hall_(hall), stream_(std::move(socket)) {
  hall_.visits.insert(this);
  error_code error;
  stream_.socket().set_option(asio::ip::tcp::no_delay(true), error);
}

void PageVisit::ReadRequest() {
  parser_.emplace();
  parser_->header_limit(PageServer::kMostHeaderBytes);
  parser_->body_limit(PageServer::kMostBodyBytes);
  stream_.expires_after(kHttpPatience);
  http::async_read(stream_, buffer_, *parser_,
                   [self = shared_from_this()](error_code error, std::size_t) {
                     if (!error) self->OnRequest();
                   });
}

std::string PageVisit::Field(http::field field) const { return std::string(View(request_[field])); }

bool PageVisit::IsFromOwnPage() const {
  return IsOwnPage(View(request_[http::field::origin]), View(request_[http::field::host]));
}

void PageVisit::OnRequest() {
  request_ = parser_->release();
  if (websocket::is_upgrade(request_)) return OnUpgrade();
  if (request_.method() == http::verb::post) return OnPost();
  if (request_.method() != http::verb::get && request_.method() != http::verb::head) {
    return Reply(http::status::method_not_allowed, kText, "Only GET and POST are served here.\n");
  }
  std::optional<WebFile> file = hall_.files.Find(View(request_.target()));
  if (file) return Reply(http::status::ok, file->type, std::move(file->bytes));
  Reply(http::status::not_found, kText, "Nothing is here.\n");
}

void PageVisit::OnPost() {
  if (!IsFromOwnPage()) {
    return Reply(http::status::forbidden, kText, "This page is of another origin.\n");
  }
  if (request_.target() == "/login") return LogIn();
  if (request_.target() == "/logout") {
    hall_.access.LogOut(SessionOf(Field(http::field::cookie)));
    return Reply(http::status::no_content, kText, "", SetSessionCookie("", hall_.is_https));
  }
  Reply(http::status::not_found, kText, "Nothing is here.\n");
}

void PageVisit::LogIn() {
  const PageAccess::Entry entry = hall_.access.LogIn(TokenOf(request_.body()), hall_.clock.Now());
  if (!entry.refusal.empty()) return Reply(http::status::forbidden, kText, entry.refusal + "\n");
  Reply(http::status::no_content, kText, "", SetSessionCookie(entry.session, hall_.is_https));
}

void PageVisit::Reply(http::status status, const std::string& type, std::string body,
                      const std::string& cookie) {
  auto reply = std::make_shared<http::response<http::string_body>>(status, request_.version());
  if (status != http::status::no_content) reply->set(http::field::content_type, type);
  reply->set(http::field::cache_control, "no-store");
  reply->set("Referrer-Policy", "no-referrer");
  reply->set(http::field::x_frame_options, "DENY");
  reply->set("X-Content-Type-Options", "nosniff");
  reply->set("Content-Security-Policy", kContentSecurityPolicy);
  if (!cookie.empty()) reply->set(http::field::set_cookie, cookie);
  reply->keep_alive(request_.keep_alive());
  if (status != http::status::no_content) reply->content_length(body.size());
  if (request_.method() != http::verb::head) reply->body() = std::move(body);
  stream_.expires_after(kHttpPatience);
  http::async_write(stream_, *reply,
                    [self = shared_from_this(), reply](error_code error, std::size_t) {
                      if (!error && reply->keep_alive()) self->ReadRequest();
                    });
}

void PageVisit::OnUpgrade() {
  session_ = std::string(SessionOf(Field(http::field::cookie)));
  const std::optional<PagePass> pass = hall_.access.Find(session_, hall_.clock.Now());
  const bool is_welcome = pass && IsFromOwnPage() && request_.target() == "/live";
  if (!is_welcome) {
    request_.keep_alive(false);
    return Reply(http::status::forbidden, kText, "Log in with the link of a message.\n");
  }
  pass_ = *pass;
  stream_.expires_never();  // the WebSocket has its own
  socket_.emplace(std::move(stream_));
  // A page that has gone without a word is missed within seconds.
  websocket::stream_base::timeout timeout{};
  timeout.handshake_timeout = std::chrono::seconds(10);
  timeout.idle_timeout = std::chrono::seconds(10);
  timeout.keep_alive_pings = true;
  socket_->set_option(timeout);
  socket_->read_message_max(PageServer::kMostMessageBytes);
  socket_->async_accept(request_, [self = shared_from_this()](error_code error) {
    if (!error) self->Begin();
  });
}

void PageVisit::Begin() {
  client_ = ++hall_.clients_so_far;
  hall_.clients[client_] = shared_from_this();
  hall_.Put({PageEvent::Kind::kJoined, client_, pass_, ""});
  ReadMessage();
}

void PageVisit::ReadMessage() {
  buffer_.clear();
  socket_->async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
    error ? self->End() : self->OnMessage();
  });
}

void PageVisit::OnMessage() {
  const Time now = hall_.clock.Now();
  const bool may = socket_->got_text() &&
                   limit_.MayPass(std::chrono::duration<double>(now).count()) &&
                   hall_.access.Find(session_, now);  // not logged out, not over
  if (!may) return End();
  hall_.Put({PageEvent::Kind::kText, client_, pass_, beast::buffers_to_string(buffer_.data())});
  ReadMessage();
}

void PageVisit::Send(const std::string& key, std::shared_ptr<const std::string> message,
                     bool is_binary) {
  const auto same = std::find_if(waiting_.begin(), waiting_.end(), [&](const Message& one) {
    return !key.empty() && one.key == key;
  });
  if (same != waiting_.end()) {
    same->bytes = std::move(message);
    return;
  }
  if (waiting_.size() >= PageServer::kMostWaiting) return End();
  waiting_.push_back({key, std::move(message), is_binary});
  WriteNext();
}

void PageVisit::WriteNext() {
  if (on_the_way_ || waiting_.empty() || client_ == 0) return;
  on_the_way_ = std::move(waiting_.front());
  waiting_.pop_front();
  socket_->binary(on_the_way_->is_binary);
  socket_->async_write(asio::buffer(*on_the_way_->bytes),
                       [self = shared_from_this()](error_code error, std::size_t) {
                         self->on_the_way_.reset();
                         error ? self->End() : self->WriteNext();
                       });
}

void PageVisit::End() {
  const std::uint64_t client = std::exchange(client_, 0);
  if (client != 0) hall_.Put({PageEvent::Kind::kLeft, client, pass_, ""});
  if (socket_) {
    beast::get_lowest_layer(*socket_).close();
  } else {
    stream_.close();
  }
  hall_.clients.erase(client);
}

}  // namespace coppice::robot
