#include "bt_core/live/web/web_port.h"

#include <pthread.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <csignal>
#include <map>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "bt_core/live/web/local_address.h"

namespace coppice {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr auto kPause = std::chrono::milliseconds(200);

// Who of a full port has to give way.
class Standings {
 public:
  Standings(const std::set<PortConnection*>& all, std::size_t most) : all_(all), half_(most / 2) {
    for (const PortConnection* one : all) {
      ++claims_[one->claim()];
      if (one->claim() == Claim::kStranger) ++strangers_[one->address()];
    }
  }

  // Null if nobody has to.
  PortConnection* Least() const {
    PortConnection* least = nullptr;
    for (PortConnection* one : all_) {
      if (GivesWay(one->claim()) && (!least || Of(*one) < Of(*least))) least = one;
    }
    return least;
  }

 private:
  bool GivesWay(Claim claim) const {
    const auto count = [this](Claim of) { return claims_.count(of) > 0 ? claims_.at(of) : 0; };
    switch (claim) {
      case Claim::kWatches:
        return count(claim) > half_;
      case Claim::kIdleControls:
        return count(claim) + count(Claim::kControls) > half_;
      default:
        return claim < Claim::kWatches;
    }
  }

  std::tuple<Claim, std::size_t, PortConnection::Moment> Of(const PortConnection& one) const {
    const auto crowd = strangers_.find(one.address());
    const bool is_stranger = one.claim() == Claim::kStranger;
    return {one.claim(), is_stranger ? all_.size() - crowd->second : 0, one.last_heard()};
  }

  const std::set<PortConnection*>& all_;
  const std::size_t half_;
  std::map<Claim, std::size_t> claims_;
  std::map<std::string, std::size_t> strangers_;  // by address
};

}  // namespace

WebPort::WebPort(const WebPortOptions& options, Handler handler)
    : port_(AlsoListen(options, std::move(handler))) {
  thread_ = std::thread([this, name = options.thread] { Run(name); });
}

std::uint16_t WebPort::AlsoListen(const WebPortOptions& options, Handler handler) {
  const auto door = std::make_shared<Door>(context_, options.most_connections, std::move(handler));
  Bind(*door, options);
  const std::uint16_t port = door->acceptor.local_endpoint().port();
  asio::post(context_, [this, door] {
    doors_.push_back(door);
    Accept(*door);
  });
  return port;
}

void WebPort::Stop() {
  if (!thread_.joinable()) return;
  asio::post(context_, [this] { Finish(); });
  thread_.join();
  doors_.clear();
  is_finishing_ = false;
}

void WebPort::Bind(Door& door, const WebPortOptions& options) {
  try {
    const asio::ip::tcp::endpoint endpoint(asio::ip::make_address(LocalAddress(options.address)),
                                           options.port);
    door.acceptor.open(endpoint.protocol());
    door.acceptor.set_option(asio::socket_base::reuse_address(true));
    door.acceptor.bind(endpoint);
    door.acceptor.listen();
  } catch (const boost::system::system_error& error) {
    throw std::runtime_error(error.code().message());
  }
}

void WebPort::Accept(Door& door) {
  door.acceptor.async_accept([this, &door](error_code error, Socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      Accept(door);
      return Admit(door, std::move(socket));
    }
    // No descriptors left, for example: not at once again.
    door.pause.expires_after(kPause);
    door.pause.async_wait([this, &door](error_code cancelled) {
      if (!cancelled) Accept(door);
    });
  });
}

void WebPort::Admit(Door& door, Socket socket) {
  if (door.connections.size() >= door.most_connections && !MakeRoom(door)) return;
  error_code gone;
  const asio::ip::tcp::endpoint from = socket.remote_endpoint(gone);
  const std::shared_ptr<PortConnection> connection = door.handler(std::move(socket), *this);
  if (!gone) connection->address_ = from.address().to_string();
  door.connections.insert(connection.get());
  connection->Start();
}

bool WebPort::MakeRoom(Door& door) {
  const Standings standings(door.connections, door.most_connections);
  PortConnection* const leaving = standings.Least();
  if (!leaving) return false;
  door.connections.erase(leaving);
  leaving->HangUp();
  return true;
}

void WebPort::Run(const char* name) {
  pthread_setname_np(pthread_self(), name);
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

void WebPort::Finish() {
  for (const std::shared_ptr<Door>& door : doors_) {
    door->acceptor.close();
    door->pause.cancel();
    const std::set<PortConnection*> connections = door->connections;
    for (PortConnection* const connection : connections) {
      if (door->connections.count(connection) > 0) connection->Finish();
    }
  }
  if (IsEmpty()) return context_.stop();
  end_.expires_after(kPause);
  end_.async_wait([this](error_code) { context_.stop(); });
  is_finishing_ = true;
}

bool WebPort::IsEmpty() const {
  return std::all_of(doors_.begin(), doors_.end(),
                     [](const auto& door) { return door->connections.empty(); });
}

void WebPort::Forget(PortConnection* connection) {
  for (const std::shared_ptr<Door>& door : doors_) door->connections.erase(connection);
  if (is_finishing_ && IsEmpty()) end_.cancel();
}

}  // namespace coppice
