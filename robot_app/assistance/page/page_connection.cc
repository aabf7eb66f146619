#include "robot_app/assistance/page/page_connection.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "bt_core/live/web/web_access.h"

namespace coppice::robot::assistance {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

WebConnectionOptions ConnectionOptions() {
  WebConnectionOptions options;
  options.header_bytes = PageServer::kMostHeaderBytes;
  options.body_bytes = PageServer::kMostBodyBytes;
  options.fields = {{"Cache-Control", "no-store"},
                    {"Referrer-Policy", "no-referrer"},
                    {"Content-Security-Policy", kContentSecurityPolicy}};
  options.not_found = "Nothing is here.\n";
  return options;
}

}  // namespace

PageSharedState::PageSharedState(const PageServerOptions& options, PageAccess& page_access,
                                 const Clock& page_clock)
    : access(page_access),
      clock(page_clock),
      files(options.folder),
      options(ConnectionOptions()),
      is_https(options.is_https) {}

void PageSharedState::EndWithoutSession() {
  const Time now = clock.Now();
  const auto open = clients;  // who ends is taken out
  for (const auto& [client, connection] : open) {
    if (!access.Find(connection->session(), now)) connection->End();
  }
}

void PageSharedState::KeepFewOf(const std::string& session) {
  std::vector<std::shared_ptr<PageConnection>> same;  // the oldest first
  for (const auto& [client, connection] : clients) {
    if (connection->session() == session) same.push_back(connection);
  }
  for (std::size_t i = 0; i + PageServer::kMostOfASession < same.size(); ++i) same[i]->End();
}

Claim PageConnection::claim() const {
  if (!socket_) return Claim::kStranger;
  return pass_.role == PageRole::kOperator ? Claim::kControls : Claim::kWatches;
}

bool PageConnection::IsFromOwnPage() const {
  return IsOwnPage(Field(http::field::origin), Field(http::field::host));
}

void PageConnection::OnPost() {
  if (!IsFromOwnPage()) {
    return Reply(Status::forbidden, "This page is of another origin.\n");
  }
  if (request().target() == "/login") return LogIn();
  if (request().target() == "/logout") {
    shared_.access.LogOut(SessionOf(Field(http::field::cookie)));
    shared_.EndWithoutSession();
    return GiveSession("");
  }
  NotFound();
}

void PageConnection::LogIn() {
  error_code unknown;
  const std::string address = stream_.socket().remote_endpoint(unknown).address().to_string();
  const Expected<PageAccess::Entry> entry =
      shared_.access.LogIn(TokenOf(request().body()), address, shared_.clock.Now());
  if (!entry) return Reply(Status::forbidden, entry.problem() + "\n");
  GiveSession(entry->session);
}

void PageConnection::GiveSession(const std::string& session) {
  Reply(Status::no_content, "", {{"Set-Cookie", SetSessionCookie(session, shared_.is_https)}});
}

void PageConnection::OnUpgrade() {
  session_ = std::string(SessionOf(Field(http::field::cookie)));
  const std::optional<PagePass> pass = shared_.access.Find(session_, shared_.clock.Now());
  const bool is_welcome = pass && IsFromOwnPage() && request().target() == "/live";
  if (!is_welcome) return Refuse(Status::forbidden, "Log in with the link of a message.\n");
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
  socket_->async_accept(request(), [self = Self()](error_code error) {
    if (!error) self->Begin();
  });
}

void PageConnection::Begin() {
  client_ = ++shared_.clients_so_far;
  shared_.clients[client_] = Self();
  shared_.KeepFewOf(session_);
  shared_.Put({PageEvent::Kind::kJoined, client_, pass_, ""});
  ReadMessage();
}

void PageConnection::ReadMessage() {
  buffer_.clear();
  socket_->async_read(buffer_, [self = Self()](error_code error, std::size_t) {
    error ? self->End() : self->OnMessage();
  });
}

void PageConnection::OnMessage() {
  Hear();
  const Time now = shared_.clock.Now();
  const bool may = socket_->got_text() &&
                   limit_.MayPass(std::chrono::duration<double>(now.time_since_epoch()).count()) &&
                   shared_.access.Find(session_, now);  // not logged out, not over
  if (!may) return End();
  shared_.Put({PageEvent::Kind::kText, client_, pass_, beast::buffers_to_string(buffer_.data())});
  ReadMessage();
}

void PageConnection::Send(const std::string& key, std::shared_ptr<const std::string> message,
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

void PageConnection::WriteNext() {
  if (on_the_way_ || waiting_.empty() || client_ == 0) return;
  on_the_way_ = std::move(waiting_.front());
  waiting_.pop_front();
  socket_->binary(on_the_way_->is_binary);
  socket_->async_write(asio::buffer(*on_the_way_->bytes),
                       [self = Self()](error_code error, std::size_t) {
                         self->on_the_way_.reset();
                         error ? self->End() : self->WriteNext();
                       });
}

void PageConnection::End() {
  const std::uint64_t client = std::exchange(client_, 0);
  if (client != 0) shared_.Put({PageEvent::Kind::kLeft, client, pass_, ""});
  if (socket_) {
    beast::get_lowest_layer(*socket_).close();
  } else {
    stream_.close();
  }
  shared_.clients.erase(client);
}

}  // namespace coppice::robot::assistance
