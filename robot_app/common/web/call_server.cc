#include "robot_app/common/web/call_server.h"

#include <chrono>
#include <stdexcept>
#include <utility>

#include "bt_core/live/web/web_access.h"
#include "bt_core/live/web/web_connection.h"
#include "robot_app/common/web/rate_limit.h"

namespace coppice::robot {
namespace {

namespace http = boost::beast::http;

constexpr char kCall[] = "/call";

WebConnectionOptions ConnectionOptions() {
  WebConnectionOptions options;
  options.body_bytes = CallServer::kMostBodyBytes;
  options.fields = {{"Cache-Control", "no-store"},
                    {"Referrer-Policy", "no-referrer"},
                    {"Content-Security-Policy", kCallPagePolicy}};
  options.not_found = "Nothing is here.\n";
  return options;
}

// Of all connections; their thread only.
struct Shared {
  const WebFiles files;
  const WebConnectionOptions options = ConnectionOptions();
  const CallServer::Reply reply;
  const std::string name;
  RateLimit limit{CallServer::kMostCallsPerSecond};
};

class CallConnection : public WebConnection {
 public:
  CallConnection(WebPort::Socket socket, WebPort& port, Shared& shared)
      : WebConnection(std::move(socket), port, shared.files, shared.options), shared_(shared) {}

 private:
  void OnUpgrade() override { Refuse(Status::forbidden, "Nothing is here.\n"); }

  void OnPost() override {
    const std::string_view host = Field(http::field::host);
    const bool is_own_name = IsLocalName(host) || (!shared_.name.empty() &&
                                                   host.substr(0, host.find(':')) == shared_.name);
    if (!is_own_name || !IsOwnPage(Field(http::field::origin), host)) {
      return Refuse(Status::forbidden, "This page is of another origin.\n");
    }
    if (request().target() != kCall) return NotFound();
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    if (!shared_.limit.MayPass(std::chrono::duration<double>(now).count())) {
      return Refuse(Status::too_many_requests, "Too often.\n");
    }
    Hear();
    Reply(Status::ok, shared_.reply(request().body()));
  }

  Shared& shared_;
};

}  // namespace

class CallServer::Loop {
 public:
  Loop(const CallServerOptions& options, Reply reply)
      : shared_{WebFiles(options.folder), ConnectionOptions(), std::move(reply), options.name},
        port_({options.address, options.port, "call_server", kMostConnections},
              [this](WebPort::Socket socket, WebPort& port) {
                return std::make_shared<CallConnection>(std::move(socket), port, shared_);
              }) {}
  ~Loop() { port_.Stop(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_.port(); }

 private:
  Shared shared_;
  WebPort port_;
};

CallServer::CallServer(const CallServerOptions& options, Reply reply) try
    : loop_(std::make_unique<Loop>(options, std::move(reply))) {
} catch (const std::runtime_error& error) {
  throw std::runtime_error("the page cannot be served on " + options.address + ":" +
                           std::to_string(options.port) + " (" + error.what() + ")");
}

CallServer::~CallServer() = default;

std::uint16_t CallServer::port() const { return loop_->port(); }

}  // namespace coppice::robot
