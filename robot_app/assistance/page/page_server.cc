#include "robot_app/assistance/page/page_server.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <stdexcept>
#include <utility>

#include "robot_app/assistance/page/page_connection.h"

namespace coppice::robot::assistance {

namespace asio = boost::asio;

class PageServer::Loop {
 public:
  Loop(const PageServerOptions& options, PageAccess& access, const Clock& clock)
      : shared_(options, access, clock),
        port_({options.address, options.port, "page_server", kMostConnections},
              [this](WebPort::Socket socket, WebPort& port) {
                return std::make_shared<PageConnection>(std::move(socket), port, shared_);
              }) {
    asio::post(port_.context(), [this] { LookAtSessions(); });
  }
  ~Loop() {
    port_.Stop();
    shared_.clients.clear();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  std::uint16_t port() const { return port_.port(); }

  bool Receive(PageEvent& event) {
    const std::lock_guard<std::mutex> lock(shared_.mutex);
    if (shared_.events.empty()) return false;
    event = std::move(shared_.events.front());
    shared_.events.pop_front();
    return true;
  }

  void Send(std::uint64_t client, const std::string& key,
            std::shared_ptr<const std::string> message, bool is_binary) {
    asio::post(port_.context(), [this, client, key, message = std::move(message), is_binary] {
      const auto found = shared_.clients.find(client);
      if (found == shared_.clients.end()) return;
      const std::shared_ptr<PageConnection> connection = found->second;
      connection->Send(key, message, is_binary);
    });
  }

 private:
  void LookAtSessions() {
    shared_.EndWithoutSession();
    look_.expires_after(std::chrono::seconds(1));
    look_.async_wait([this](boost::system::error_code cancelled) {
      if (!cancelled) LookAtSessions();
    });
  }

  PageSharedState shared_;
  WebPort port_;
  asio::steady_timer look_{port_.context()};
};

PageServer::PageServer(const PageServerOptions& options, PageAccess& access, const Clock& clock) try
    : loop_(std::make_unique<Loop>(options, access, clock)) {
} catch (const std::runtime_error& error) {
  throw std::runtime_error("the supervisor page cannot be served on " + options.address + ":" +
                           std::to_string(options.port) + " (" + error.what() + ")");
}

PageServer::~PageServer() = default;

std::uint16_t PageServer::port() const { return loop_->port(); }
bool PageServer::Receive(PageEvent& event) { return loop_->Receive(event); }
void PageServer::Send(std::uint64_t client, const std::string& key,
                      std::shared_ptr<const std::string> message, bool is_binary) {
  loop_->Send(client, key, std::move(message), is_binary);
}

}  // namespace coppice::robot::assistance
