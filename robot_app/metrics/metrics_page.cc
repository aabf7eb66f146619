#include "robot_app/metrics/metrics_page.h"

#include <sodium.h>

#include <stdexcept>
#include <utility>

#include "bt_core/live/web/web_access.h"
#include "bt_core/live/web/web_connection.h"

namespace coppice::robot::metrics {
namespace {

namespace http = boost::beast::http;

constexpr std::size_t kMostConnections = 32;
constexpr const char* kFormat = "text/plain; version=0.0.4; charset=utf-8";

bool IsOnThisComputer(const std::string& address) {
  return address == "localhost" || address == "::1" || address.compare(0, 4, "127.") == 0;
}

// What the connections have in common.
struct Shared {
  std::string authorization;  // the header field that is asked for; empty: none
  std::function<std::string()> text;
  WebFiles files{""};
  WebConnectionOptions options{};
};

// Takes as long whatever is wrong.
bool IsSame(std::string_view a, const std::string& b) {
  return a.size() == b.size() && sodium_memcmp(a.data(), b.data(), b.size()) == 0;
}

class Connection final : public WebConnection {
 public:
  Connection(WebPort::Socket socket, WebPort& port, const Shared& shared)
      : WebConnection(std::move(socket), port, shared.files, shared.options), shared_(shared) {}

 private:
  void OnUpgrade() override { Refuse(Status::forbidden, "there is no WebSocket here\n"); }

  void OnGet() override {
    if (!shared_.authorization.empty() &&
        !IsSame(Field(http::field::authorization), shared_.authorization)) {
      return Reply(Status::unauthorized, "a token is needed\n", {{"WWW-Authenticate", "Bearer"}});
    }
    if (shared_.authorization.empty() && !IsLocalName(Field(http::field::host))) {
      return Refuse(Status::forbidden, "without a token only this computer is served\n");
    }
    if (request().target() != "/metrics") return NotFound();
    Reply(Status::ok, shared_.text(), {{"Content-Type", kFormat}});
  }

  const Shared& shared_;
};

}  // namespace

struct MetricsPage::Server {
  Server(const MetricsPageOptions& page, std::function<std::string()> text)
      : shared{page.token.empty() ? "" : "Bearer " + page.token, std::move(text)},
        port({page.address, page.port, "metrics", kMostConnections},
             [this](WebPort::Socket socket, WebPort& web) {
               return std::make_shared<Connection>(std::move(socket), web, shared);
             }) {
    shared.options.not_found = "the figures are at /metrics\n";
  }
  ~Server() { port.Stop(); }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  Shared shared;
  WebPort port;
};

MetricsPage::MetricsPage(const MetricsPageOptions& options, std::function<std::string()> text) try {
  if (options.token.empty() && !IsOnThisComputer(options.address)) {
    throw std::runtime_error("without a token only this computer is served");
  }
  server_ = std::make_unique<Server>(options, std::move(text));
} catch (const std::runtime_error& error) {
  throw std::runtime_error("metrics cannot be served on " + options.address + ":" +
                           std::to_string(options.port) + " (" + error.what() + ")");
}

MetricsPage::~MetricsPage() = default;

std::uint16_t MetricsPage::port() const { return server_->port.port(); }

}  // namespace coppice::robot::metrics
