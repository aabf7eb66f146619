#include "bt_core/live/web/web_gateway.h"

#include <boost/asio/post.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <optional>
#include <stdexcept>
#include <utility>

#include "bt_core/live/client/part_packing.h"
#include "bt_core/live/web/web_connection.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using beast::error_code;

WebConnectionOptions ConnectionOptions() {
  WebConnectionOptions options;
  options.header_bytes = WebGateway::kMaxHeaderBytes;
  options.fields = {{"Cache-Control", "no-cache"}};
  options.not_found =
      "nothing is here; the editor's page is part of builds with -DCOPPICE_WEB=ON\n";
  return options;
}

// What the connections have in common.
struct SharedState {
  SharedState(const WebGatewayOptions& options, LiveClients& all)
      : access(options.tokens), files(options.folder), clients(all) {}

  const WebAccess access;
  const WebFiles files;
  const WebConnectionOptions options = ConnectionOptions();
  LiveClients& clients;
};

// The gateway's thread only, but for what LiveConnection promises.
class Connection final : public WebConnection, public LiveConnection {
 public:
  Connection(WebPort::Socket socket, WebPort& port, SharedState& shared)
      : WebConnection(std::move(socket), port, shared.files, shared.options),
        shared_(shared),
        port_context_(port.context()) {}

  void Post(groot2::Parts message, std::size_t bytes) override {
    asio::post(port_context_, [self = Self(), message = std::move(message), bytes] {
      self->Write({PackParts(message), bytes});
    });
  }
  void ReadOn() override {
    asio::post(port_context_, [self = Self()] { self->ReadMessage(); });
  }
  void CutOff() override {
    asio::post(port_context_, [self = Self()] { self->End(); });
  }

  void HangUp() override { socket_ ? End() : WebConnection::HangUp(); }
  Claim claim() const override {
    if (!socket_) return Claim::kStranger;
    return may_control_ ? Claim::kControls : Claim::kWatches;
  }

  void Finish() override {
    is_finishing_ = true;
    if (!socket_) return WebConnection::Finish();
    if (client_ == ClientId()) return beast::get_lowest_layer(*socket_).close();
    if (unsent_.empty()) Close();
  }

 private:
  struct Output {
    std::string bytes;
    std::size_t room = 0;  // that was taken for it
  };

  std::shared_ptr<Connection> Self() {
    return std::static_pointer_cast<Connection>(shared_from_this());
  }

  void OnUpgrade() override {
    const Expected<WebRole> role =
        shared_.access.Judge({Field(http::field::host), Field(http::field::origin),
                              Field(http::field::sec_websocket_protocol)});
    if (!role) return Refuse(Status::forbidden, role.problem() + "\n");
    may_control_ = *role == WebRole::kControl;
    stream_.expires_never();  // the WebSocket has its own
    socket_.emplace(std::move(stream_));
    socket_->set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    socket_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
      response.set(http::field::sec_websocket_protocol, kWebProtocol);
    }));
    socket_->read_message_max(LiveClients::kMaxRequestBytes);
    socket_->binary(true);
    socket_->async_accept(request(), [self = Self()](error_code error) {
      if (!error) self->Begin();
    });
  }

  void Begin() {
    client_ = shared_.clients.Enter(Self(), may_control_);
    ReadMessage();
  }

  void ReadMessage() {
    buffer_.clear();
    socket_->async_read(buffer_, [self = Self()](error_code error, std::size_t) {
      error ? self->End() : self->OnMessage();
    });
  }

  // The next one is read when this one was taken.
  void OnMessage() {
    Hear();
    const std::string message = beast::buffers_to_string(buffer_.data());
    groot2::Parts parts = socket_->got_binary() ? UnpackParts(message) : groot2::Parts();
    if (!parts.empty()) return shared_.clients.Put(client_, std::move(parts));
    shared_.clients.Leave(client_);
    Close(websocket::close_code::bad_payload);
  }

  void Write(Output output) {
    unsent_.push_back(std::move(output));
    if (unsent_.size() == 1) WriteNext();
  }

  void WriteNext() {
    socket_->async_write(asio::buffer(unsent_.front().bytes),
                         [self = Self()](error_code error, std::size_t) {
                           error ? self->End() : self->OnWritten();
                         });
  }

  void OnWritten() {
    shared_.clients.GiveRoom(client_, unsent_.front().room);
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

  // What the client holds is released. Nobody else may hold this connection any more.
  void End() {
    const std::shared_ptr<Connection> self = Self();
    shared_.clients.Leave(client_);
    beast::get_lowest_layer(*socket_).close();
  }

  SharedState& shared_;
  asio::io_context& port_context_;
  std::optional<websocket::stream<beast::tcp_stream>> socket_;
  ClientId client_{};
  bool may_control_ = false;
  bool is_finishing_ = false;
  bool is_closing_ = false;
  std::deque<Output> unsent_;
};

}  // namespace

class WebGateway::Loop {
 public:
  Loop(const WebGatewayOptions& options, LiveClients& clients)
      : shared_(options, clients),
        port_({options.address, options.port, "coppice_web", kMaxConnections},
              [this](WebPort::Socket socket, WebPort& port) {
                return std::make_shared<Connection>(std::move(socket), port, shared_);
              }) {}

  ~Loop() {
    Stop();
    shared_.clients.Clear();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void Stop() { port_.Stop(); }
  std::uint16_t port() const { return port_.port(); }

 private:
  SharedState shared_;
  WebPort port_;
};

WebGateway::WebGateway(const WebGatewayOptions& options, LiveClients& clients) try
    : loop_(std::make_unique<Loop>(options, clients)) {
} catch (const std::runtime_error& error) {
  throw std::runtime_error("live view: the web page cannot be served on " + options.address + ":" +
                           std::to_string(options.port) + " (" + error.what() +
                           "); choose an address of this computer and another web port");
}

WebGateway::~WebGateway() = default;

std::uint16_t WebGateway::port() const { return loop_->port(); }
void WebGateway::Stop() { loop_->Stop(); }

}  // namespace coppice
