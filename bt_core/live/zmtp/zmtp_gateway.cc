#include "bt_core/live/zmtp/zmtp_gateway.h"

#include <stdexcept>
#include <utility>

#include "bt_core/live/web/web_port.h"
#include "bt_core/live/zmtp/zmtp_connection.h"

namespace coppice {
namespace {

std::string WhyNot(const std::string& place, const std::string& reason) {
  if (reason == "Address already in use") {
    return "live view: port " + place +
           " is in use; end the program that has it or choose another port (each tree needs two "
           "neighbouring ones, for example 1669 and 1670)";
  }
  return "live view: cannot listen on " + place + " (" + reason +
         "); choose an address of this computer and a port above 1023";
}

}  // namespace

class ZmtpGateway::Loop {
 public:
  Loop(const std::string& address, std::optional<RobotKeys> keys, LiveClients& clients)
      : address_(address), keys_(std::move(keys)), clients_(clients) {}

  ~Loop() {
    Stop();
    clients_.Clear();
  }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void Listen(std::uint16_t port) {
    if (port == UINT16_MAX) {
      throw std::runtime_error("live view: port 65535 has no neighbour for notifications");
    }
    const auto first = [&] {
      port_.reset();
      port_.emplace(Options(port), HandlerFor(ZmtpConnection::Type::kRouter));
    };
    const auto second = [&] {
      const auto neighbour = static_cast<std::uint16_t>(port_->port() + 1);
      port_->AlsoListen(Options(neighbour), HandlerFor(ZmtpConnection::Type::kPublisher));
    };
    Try(port, first);
    Try(port_->port() + 1, second);
  }

  // The system chooses the first port; the one after it may be taken, then another try is made.
  void ListenOnFreePair() {
    constexpr int kAttempts = 100;
    for (int attempt = 1; attempt < kAttempts; ++attempt) {
      try {
        return Listen(0);
      } catch (const std::runtime_error&) {
        if (!port_) throw;
      }
    }
    Listen(0);
  }

  void Stop() {
    if (port_) port_->Stop();
  }
  std::uint16_t port() const { return port_->port(); }

 private:
  WebPortOptions Options(std::uint16_t port) const {
    return {address_, port, "coppice_zmtp", kMaxConnections};
  }

  WebPort::Handler HandlerFor(ZmtpConnection::Type type) {
    return [this, type](WebPort::Socket socket, WebPort& port) {
      return std::make_shared<ZmtpConnection>(std::move(socket), port, type,
                                              keys_ ? &*keys_ : nullptr, clients_);
    };
  }

  template <typename Do>
  void Try(int port, const Do& listen) const {
    try {
      listen();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(
          WhyNot(port == 0 ? address_ : address_ + ":" + std::to_string(port), error.what()));
    }
  }

  const std::string address_;
  const std::optional<RobotKeys> keys_;
  LiveClients& clients_;
  std::optional<WebPort> port_;
};

ZmtpGateway::ZmtpGateway(const std::string& address, std::uint16_t port,
                         std::optional<RobotKeys> keys, LiveClients& clients)
    : loop_(std::make_unique<Loop>(address, std::move(keys), clients)) {
  port == 0 ? loop_->ListenOnFreePair() : loop_->Listen(port);
}

ZmtpGateway::~ZmtpGateway() = default;

void ZmtpGateway::Stop() { loop_->Stop(); }

std::uint16_t ZmtpGateway::port() const { return loop_->port(); }

}  // namespace coppice
