#include "bt_core/live/web_gateway.h"

#include <pthread.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <csignal>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include "bt_core/live/local_address.h"
#include "bt_core/live/part_packing.h"
#include "bt_core/live/web_files.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using beast::error_code;

constexpr auto kHttpPatience = std::chrono::seconds(20);
constexpr auto kLinger = std::chrono::milliseconds(200);

// ZeroMQ numbers its clients with a zero and four bytes; other names cannot begin with a zero.
constexpr std::string_view kClientPrefix("\0web", 4);

std::string_view View(beast::string_view text) { return {text.data(), text.size()}; }

class Visit;

// What the connections have in common.
struct Hall {
  explicit Hall(const WebGatewayOptions& options, std::function<void()> callback)
      : access(options.tokens), files(options.folder), on_request(std::move(callback)) {}

  void Put(ReceivedRequest request) {
    {
      const std::lock_guard<std::mutex> lock(mutex);
      requests.push_back(std::move(request));
    }
    on_request();
  }

  const WebAccess access;
  const WebFiles files;
  const std::function<void()> on_request;
  std::set<Visit*> visits;              // the gateway's thread only
  std::function<void()> on_last_visit;  // its end, when the gateway ends
  std::uint64_t clients_so_far = 0;

  std::mutex mutex;  // for the rest
  std::map<std::string, std::shared_ptr<Visit>> clients;
  std::deque<ReceivedRequest> requests;
};

// One connection: HTTP until it asks for a WebSocket. Alive while something is awaited. The
// gateway's thread only, but for what says otherwise.
class Visit : public std::enable_shared_from_this<Visit> {
 public:
  Visit(Tcp::socket socket, Hall& hall) : hall_(hall), stream_(std::move(socket)) {
    hall_.visits.insert(this);
    error_code error;
    stream_.socket().set_option(Tcp::no_delay(true), error);
  }
  ~Visit() {
    hall_.visits.erase(this);
    if (hall_.visits.empty() && hall_.on_last_visit) hall_.on_last_visit();
  }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  void ReadRequest() {
    parser_.emplace();
    parser_->header_limit(WebGateway::kMaxHeaderBytes);
    parser_->body_limit(0);
    stream_.expires_after(kHttpPatience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (!error) self->OnRequest();
                     });
  }

  void ReadMessage() {
    buffer_.clear();
    socket_->async_read(buffer_, [self = shared_from_this()](error_code error, std::size_t) {
      error ? self->End() : self->OnMessage();
    });
  }

  /// Any thread: takes room for a message, if there is some.
  bool Reserve(std::size_t bytes) {
    const std::size_t before = unread_.load();
    if (before > 0 && before + bytes > WebGateway::kMaxUnreadBytes) return false;
    unread_ += bytes;
    return true;
  }
  /// Room was taken for it.
  void Write(std::string message) {
    unsent_.push_back(std::move(message));
    if (unsent_.size() == 1) WriteNext();
  }

  /// When everything is sent.
  void Finish() {
    is_finishing_ = true;
    if (!socket_) return stream_.close();
    if (client_.empty()) return beast::get_lowest_layer(*socket_).close();
    if (unsent_.empty()) Close();
  }

 private:
  void OnRequest() {
    request_ = parser_->release();
    if (websocket::is_upgrade(request_)) return OnUpgrade();
    if (request_.method() != http::verb::get && request_.method() != http::verb::head) {
      return Reply(http::status::method_not_allowed, "text/plain", "only GET is served here\n");
    }
    std::optional<WebFile> file = hall_.files.Find(View(request_.target()));
    if (file) return Reply(http::status::ok, file->type, std::move(file->bytes));
    Reply(http::status::not_found, "text/plain",
          "nothing is here; the editor's page is part of builds with -DCOPPICE_WEB=ON\n");
  }

  void Reply(http::status status, const char* type, std::string body) {
    auto reply = std::make_shared<http::response<http::string_body>>(status, request_.version());
    reply->set(http::field::content_type, type);
    reply->set(http::field::cache_control, "no-cache");
    reply->set(http::field::x_frame_options, "DENY");
    reply->set("X-Content-Type-Options", "nosniff");
    reply->keep_alive(request_.keep_alive());
    reply->content_length(body.size());
    if (request_.method() != http::verb::head) reply->body() = std::move(body);
    stream_.expires_after(kHttpPatience);
    http::async_write(stream_, *reply,
                      [self = shared_from_this(), reply](error_code error, std::size_t) {
                        if (!error && reply->keep_alive()) self->ReadRequest();
                      });
  }

  void OnUpgrade() {
    const WebAccess::Verdict verdict =
        hall_.access.Judge({View(request_[http::field::host]), View(request_[http::field::origin]),
                            View(request_[http::field::sec_websocket_protocol])});
    if (!verdict.refusal.empty()) {
      request_.keep_alive(false);
      return Reply(http::status::forbidden, "text/plain", verdict.refusal + "\n");
    }
    may_control_ = verdict.may_control;
    stream_.expires_never();  // the WebSocket has its own
    socket_.emplace(std::move(stream_));
    socket_->set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
      response.set(http::field::sec_websocket_protocol, kWebProtocol);
    }));
    socket_->read_message_max(WebGateway::kMaxRequestBytes);
    socket_->binary(true);
    socket_->async_accept(request_, [self = shared_from_this()](error_code error) {
      if (!error) self->Begin();
    });
  }

  void Begin() {
    client_ = std::string(kClientPrefix) + std::to_string(++hall_.clients_so_far);
    {
      const std::lock_guard<std::mutex> lock(hall_.mutex);
      hall_.clients[client_] = shared_from_this();
    }
    ReadMessage();
  }

  // The next one is read when this one was taken.
  void OnMessage() {
    const std::string message = beast::buffers_to_string(buffer_.data());
    groot2::Parts parts = socket_->got_binary() ? UnpackParts(message) : groot2::Parts();
    if (!parts.empty()) return hall_.Put({client_, may_control_, std::move(parts)});
    Leave();
    Close(websocket::close_code::bad_payload);
  }

  void WriteNext() {
    socket_->async_write(asio::buffer(unsent_.front()),
                         [self = shared_from_this()](error_code error, std::size_t) {
                           error ? self->End() : self->OnWritten();
                         });
  }

  void OnWritten() {
    unread_ -= unsent_.front().size();
    unsent_.pop_front();
    if (!unsent_.empty()) {
      WriteNext();
    } else if (is_finishing_) {
      Close();
    }
  }

  void Close(websocket::close_code code = websocket::close_code::going_away) {
    if (std::exchange(is_closing_, true)) return;
    socket_->async_close(code, [self = shared_from_this()](error_code) { self->End(); });
  }

  // Nobody can send any more, and what the client holds is released.
  void Leave() {
    {
      const std::lock_guard<std::mutex> lock(hall_.mutex);
      if (hall_.clients.erase(client_) == 0) return;
    }
    const char type = static_cast<char>(groot2::RequestType::kExtension);
    hall_.Put({client_, may_control_, {groot2::MakeHeader(type, 0), R"({"do":"bye"})"}});
  }

  void End() {
    Leave();
    beast::get_lowest_layer(*socket_).cancel();
  }

  Hall& hall_;
  beast::flat_buffer buffer_;
  beast::tcp_stream stream_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::request<http::empty_body> request_;

  std::optional<websocket::stream<beast::tcp_stream>> socket_;
  std::string client_;
  bool may_control_ = false;
  bool is_finishing_ = false;
  bool is_closing_ = false;
  std::deque<std::string> unsent_;
  std::atomic<std::size_t> unread_{0};  // bytes; also those on the way to unsent_
};

}  // namespace

class WebGateway::Loop {
 public:
  Loop(const WebGatewayOptions& options, std::function<void()> on_request)
      : hall_(options, std::move(on_request)), acceptor_(context_), linger_(context_) {
    Listen(options);
    Accept();
    thread_ = std::thread([this] { Run(); });
  }

  ~Loop() {
    asio::post(context_, [this] { Finish(); });
    thread_.join();
    hall_.on_last_visit = nullptr;
    hall_.clients.clear();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_; }

  bool Receive(ReceivedRequest& request) {
    const std::lock_guard<std::mutex> lock(hall_.mutex);
    if (hall_.requests.empty()) return false;
    request = std::move(hall_.requests.front());
    hall_.requests.pop_front();
    const auto client = hall_.clients.find(request.client);
    if (client != hall_.clients.end()) {
      asio::post(context_, [visit = client->second] { visit->ReadMessage(); });
    }
    return true;
  }

  SendResult Send(const std::string& client, const groot2::Parts& parts) {
    std::string message = PackParts(parts);
    const std::lock_guard<std::mutex> lock(hall_.mutex);
    const auto at = hall_.clients.find(client);
    if (at == hall_.clients.end()) return SendResult::kGone;
    if (!at->second->Reserve(message.size())) return SendResult::kFull;
    asio::post(context_, [visit = at->second, message = std::move(message)]() mutable {
      visit->Write(std::move(message));
    });
    return SendResult::kSent;
  }

 private:
  void Listen(const WebGatewayOptions& options) {
    const std::string place = options.address + ":" + std::to_string(options.port);
    try {
      const Tcp::endpoint endpoint(asio::ip::make_address(LocalAddress(options.address)),
                                   options.port);
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(asio::socket_base::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
      port_ = acceptor_.local_endpoint().port();
    } catch (const boost::system::system_error& error) {
      throw std::runtime_error("live view: the web page cannot be served on " + place + " (" +
                               error.code().message() +
                               "); choose an address of this computer and another web port");
    }
  }

  void Accept() {
    acceptor_.async_accept([this](error_code error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error && hall_.visits.size() < kMaxConnections) {
        std::make_shared<Visit>(std::move(socket), hall_)->ReadRequest();
      }
      if (!error) return Accept();
      // No descriptors left, for example: not at once again.
      linger_.expires_after(kLinger);
      linger_.async_wait([this](error_code cancelled) {
        if (!cancelled) Accept();
      });
    });
  }

  void Run() {
    pthread_setname_np(pthread_self(), "coppice_web");
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    while (true) {
      try {
        context_.run();
        return;
      } catch (const std::exception&) {  // no memory: that connection ends
      }
    }
  }

  void Finish() {
    acceptor_.close();
    const std::set<Visit*> visits = hall_.visits;
    for (Visit* const visit : visits) {
      if (hall_.visits.count(visit) > 0) visit->Finish();
    }
    if (hall_.visits.empty()) return context_.stop();
    linger_.expires_after(kLinger);
    linger_.async_wait([this](error_code) { context_.stop(); });
    hall_.on_last_visit = [this] { linger_.cancel(); };
  }

  Hall hall_;  // before the context, in which the last connections end
  asio::io_context context_{1};
  Tcp::acceptor acceptor_;
  asio::steady_timer linger_;
  std::uint16_t port_ = 0;
  std::thread thread_;
};

WebGateway::WebGateway(const WebGatewayOptions& options, std::function<void()> on_request)
    : loop_(std::make_unique<Loop>(options, std::move(on_request))) {}

WebGateway::~WebGateway() = default;

std::uint16_t WebGateway::port() const { return loop_->port(); }
bool WebGateway::Receive(ReceivedRequest& request) { return loop_->Receive(request); }
SendResult WebGateway::Send(const std::string& client, const groot2::Parts& parts) {
  return loop_->Send(client, parts);
}

bool WebGateway::IsWebClient(const std::string& client) {
  return std::string_view(client).substr(0, kClientPrefix.size()) == kClientPrefix;
}

}  // namespace coppice
