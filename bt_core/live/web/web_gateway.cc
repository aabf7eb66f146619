#include "bt_core/live/web/web_gateway.h"

#include <atomic>
#include <boost/asio/post.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "bt_core/live/client/part_packing.h"
#include "bt_core/live/web/web_visit.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

// ZeroMQ numbers its clients with a zero and four bytes; other names cannot begin with a zero.
constexpr std::string_view kClientPrefix("\0web", 4);

WebManners Manners() {
  WebManners manners;
  manners.header_bytes = WebGateway::kMaxHeaderBytes;
  manners.fields = {{"Cache-Control", "no-cache"}};
  manners.not_found =
      "nothing is here; the editor's page is part of builds with -DCOPPICE_WEB=ON\n";
  return manners;
}

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
  const WebManners manners = Manners();
  const std::function<void()> on_request;
  std::uint64_t clients_so_far = 0;  // the gateway's thread only

  std::mutex mutex;  // for the rest
  std::map<std::string, std::shared_ptr<Visit>> clients;
  std::deque<ReceivedRequest> requests;
};

// The gateway's thread only, but for what says otherwise.
class Visit : public WebVisit {
 public:
  Visit(WebPort::Socket socket, WebPort& port, Hall& hall)
      : WebVisit(std::move(socket), port, hall.files, hall.manners), hall_(hall) {}

  void ReadMessage() {
    buffer_.clear();
    socket_->async_read(buffer_, [self = Self()](error_code error, std::size_t) {
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

  void Finish() override {
    is_finishing_ = true;
    if (!socket_) return WebVisit::Finish();
    if (client_.empty()) return beast::get_lowest_layer(*socket_).close();
    if (unsent_.empty()) Close();
  }

 private:
  std::shared_ptr<Visit> Self() { return std::static_pointer_cast<Visit>(shared_from_this()); }

  void OnUpgrade() override {
    const WebAccess::Verdict verdict =
        hall_.access.Judge({Field(http::field::host), Field(http::field::origin),
                            Field(http::field::sec_websocket_protocol)});
    if (!verdict.refusal.empty()) return Refuse(Status::forbidden, verdict.refusal + "\n");
    may_control_ = verdict.may_control;
    stream_.expires_never();  // the WebSocket has its own
    socket_.emplace(std::move(stream_));
    socket_->set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
      response.set(http::field::sec_websocket_protocol, kWebProtocol);
    }));
    socket_->read_message_max(WebGateway::kMaxRequestBytes);
    socket_->binary(true);
    socket_->async_accept(request(), [self = Self()](error_code error) {
      if (!error) self->Begin();
    });
  }

  void Begin() {
    client_ = std::string(kClientPrefix) + std::to_string(++hall_.clients_so_far);
    {
      const std::lock_guard<std::mutex> lock(hall_.mutex);
      hall_.clients[client_] = Self();
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
                         [self = Self()](error_code error, std::size_t) {
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
    socket_->async_close(code, [self = Self()](error_code) { self->End(); });
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
      : hall_(options, std::move(on_request)),
        port_({options.address, options.port, "coppice_web", kMaxConnections},
              [this](WebPort::Socket socket, WebPort& port) {
                return std::make_shared<Visit>(std::move(socket), port, hall_);
              }) {}

  ~Loop() {
    port_.Stop();
    hall_.clients.clear();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_.port(); }

  bool Receive(ReceivedRequest& request) {
    const std::lock_guard<std::mutex> lock(hall_.mutex);
    if (hall_.requests.empty()) return false;
    request = std::move(hall_.requests.front());
    hall_.requests.pop_front();
    const auto client = hall_.clients.find(request.client);
    if (client != hall_.clients.end()) {
      asio::post(port_.context(), [visit = client->second] { visit->ReadMessage(); });
    }
    return true;
  }

  SendResult Send(const std::string& client, const groot2::Parts& parts) {
    std::string message = PackParts(parts);
    const std::lock_guard<std::mutex> lock(hall_.mutex);
    const auto at = hall_.clients.find(client);
    if (at == hall_.clients.end()) return SendResult::kGone;
    if (!at->second->Reserve(message.size())) return SendResult::kFull;
    asio::post(port_.context(), [visit = at->second, message = std::move(message)]() mutable {
      visit->Write(std::move(message));
    });
    return SendResult::kSent;
  }

 private:
  Hall hall_;
  WebPort port_;
};

WebGateway::WebGateway(const WebGatewayOptions& options, std::function<void()> on_request) try
    : loop_(std::make_unique<Loop>(options, std::move(on_request))) {
} catch (const std::runtime_error& error) {
  throw std::runtime_error("live view: the web page cannot be served on " + options.address + ":" +
                           std::to_string(options.port) + " (" + error.what() +
                           "); choose an address of this computer and another web port");
}

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
