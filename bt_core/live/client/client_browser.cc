// LiveClient in a browser: over its WebSocket, without a thread. The browser calls when something
// has come, so the listener is called between two frames.
#include <emscripten/emscripten.h>
#include <emscripten/html5.h>
#include <emscripten/websocket.h>

#include <chrono>
#include <utility>

#include "bt_core/live/client/client.h"
#include "bt_core/live/client/client_extension.h"
#include "bt_core/live/client/part_packing.h"
#include "bt_core/live/web/web_access.h"

namespace coppice {
namespace {

constexpr Duration kRetryPause = std::chrono::milliseconds(500);
constexpr double kTimerPeriod = 100;  // ms

Duration Now() { return std::chrono::steady_clock::now().time_since_epoch(); }

// A page that came encrypted may not open what is not.
std::string UrlOf(const std::string& endpoint) {
  const bool is_secure = emscripten_run_script_int("location.protocol === 'https:'") != 0;
  return (is_secure ? "wss://" : "ws://") + endpoint + "/";
}

std::string ProtocolsOf(const std::string& token) {
  return kWebProtocol + (token.empty() ? "" : std::string(",") + kWebTokenPrefix + token);
}

}  // namespace

class LiveClient::Loop {
 public:
  Loop(const std::string& endpoint, LiveListener& listener, LiveClientOptions options)
      : endpoint_(endpoint),
        url_(UrlOf(endpoint)),
        options_(std::move(options)),
        protocols_(ProtocolsOf(options_.token)),
        listener_(listener),
        history_(listener) {
    Connect();
    timer_ = emscripten_set_interval([](void* self) { Self(self).OnTimer(); }, kTimerPeriod, this);
  }

  ~Loop() {
    emscripten_clear_interval(timer_);
    if (session_) {
      session_->Leave();
      session_->Abandon("the client ends");
    }
    Disconnect();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void Send(const LiveCommand& command, ReplyHandler on_reply) {
    if (session_ && session_->is_live()) return session_->Send(command, std::move(on_reply));
    if (!on_reply) return;
    on_reply(Problem{"not connected to " + endpoint_ + (told_.empty() ? "" : ": " + told_)});
  }

 private:
  static Loop& Self(void* self) { return *static_cast<Loop*>(self); }

  void Connect() {
    EmscriptenWebSocketCreateAttributes attributes;
    emscripten_websocket_init_create_attributes(&attributes);
    attributes.url = url_.c_str();
    attributes.protocols = protocols_.c_str();
    socket_ = emscripten_websocket_new(&attributes);
    if (socket_ <= 0) return Drop("this browser opens no WebSocket to " + url_);
    emscripten_websocket_set_onopen_callback(
        socket_, this, [](int, const EmscriptenWebSocketOpenEvent*, void* self) -> EM_BOOL {
          Self(self).OnOpen();
          return EM_TRUE;
        });
    emscripten_websocket_set_onmessage_callback(
        socket_, this,
        [](int, const EmscriptenWebSocketMessageEvent* event, void* self) -> EM_BOOL {
          Self(self).OnMessage({reinterpret_cast<const char*>(event->data), event->numBytes});
          return EM_TRUE;
        });
    emscripten_websocket_set_onclose_callback(
        socket_, this, [](int, const EmscriptenWebSocketCloseEvent*, void* self) -> EM_BOOL {
          Self(self).OnClose();
          return EM_TRUE;
        });
  }

  // Nothing is called for this socket any more.
  void Disconnect() {
    if (socket_ <= 0) return;
    emscripten_websocket_set_onopen_callback(socket_, nullptr, nullptr);
    emscripten_websocket_set_onmessage_callback(socket_, nullptr, nullptr);
    emscripten_websocket_set_onclose_callback(socket_, nullptr, nullptr);
    constexpr unsigned short kNormal = 1000;
    emscripten_websocket_close(socket_, kNormal, "");
    emscripten_websocket_delete(socket_);
    socket_ = 0;
  }

  void OnOpen() {
    session_ = std::make_unique<ClientExtension>(
        options_, listener_, history_, [this](const ClientSession::Parts& parts) {
          std::string message = PackParts(parts);
          emscripten_websocket_send_binary(socket_, message.data(), message.size());
        });
  }

  void OnMessage(std::string_view message) {
    if (!session_) return;
    session_->OnMessage(UnpackParts(message), Now());
    if (session_->is_live()) told_.clear();
    DropIfFailed();
  }

  void OnClose() {
    Drop(session_ ? "the connection is closed"
                  : "no connection to " + endpoint_ +
                        "; the robot is away, or needs another token behind the # of the address");
  }

  void OnTimer() {
    if (session_) {
      session_->OnTime(Now());
      DropIfFailed();
    } else if (socket_ <= 0 && Now() >= retry_at_) {
      Connect();
    }
  }

  void DropIfFailed() {
    if (!session_->failure().empty()) Drop(session_->failure());
  }

  void Drop(const std::string& why) {
    if (const std::unique_ptr<ClientExtension> session = std::move(session_)) {
      session->Abandon(why);
    }
    Disconnect();
    retry_at_ = Now() + kRetryPause;
    if (why == told_) return;
    told_ = why;
    LiveConnection connection;
    connection.problem = why;
    listener_.OnConnection(connection);
  }

  const std::string endpoint_;
  const std::string url_;
  const LiveClientOptions options_;
  const std::string protocols_;
  LiveListener& listener_;
  ClientHistory history_;  // of all connections
  EMSCRIPTEN_WEBSOCKET_T socket_ = 0;
  std::unique_ptr<ClientExtension> session_;
  std::string told_;  // the problem that was told last
  Duration retry_at_{0};
  long timer_ = 0;
};

LiveClient::LiveClient(const std::string& endpoint, LiveListener& listener,
                       LiveClientOptions options)
    : loop_(std::make_unique<Loop>(endpoint, listener, std::move(options))) {}

LiveClient::~LiveClient() = default;

void LiveClient::Send(LiveCommand command, ReplyHandler on_reply) {
  loop_->Send(command, std::move(on_reply));
}

}  // namespace coppice
