#include "bt_core/live/server/live_sockets.h"

#include <array>
#include <cerrno>
#include <stdexcept>
#include <utility>

namespace coppice {
namespace {

constexpr std::int64_t kMaxRequestBytes = 1 << 20;
constexpr int kMaxUnread = 256;  // messages for a client that does not read
constexpr int kLinger = 200;     // ms: for what was sent when the program ends

std::string Endpoint(const std::string& address, const std::string& port) {
  return "tcp://" + address + ":" + port;
}

std::uint16_t BoundPort(const zmq::socket_t& socket) {
  const std::string endpoint = socket.get(zmq::sockopt::last_endpoint);
  return static_cast<std::uint16_t>(std::stoi(endpoint.substr(endpoint.rfind(':') + 1)));
}

std::string WhyNot(const std::string& place, const zmq::error_t& error) {
  if (error.num() == EADDRINUSE) {
    return "live view: port " + place +
           " is in use; end the program that has it or choose another port (each tree needs two "
           "neighbouring ones, for example 1669 and 1670)";
  }
  return "live view: cannot listen on " + place + " (" + error.what() +
         "); choose an address of this computer and a port above 1023";
}

}  // namespace

LiveSockets::LiveSockets(const std::string& address, std::uint16_t port,
                         std::optional<RobotKeys> keys) {
  if (keys && zmq_has("curve") == 0) {
    throw std::runtime_error(
        "live view: this ZeroMQ was built without CURVE, so there can be no token; listen on "
        "127.0.0.1 without one");
  }
  if (keys) gate_.emplace(context_, *std::move(keys));
  if (port == UINT16_MAX) {
    throw std::runtime_error("live view: port 65535 has no neighbour for notifications");
  }
  if (port == 0) {
    BindFreePair(address);
  } else {
    port_ = port;
    MakeSockets();
    Bind(requests_, address, port);
    Bind(notifications_, address, port + 1);
  }
}

void LiveSockets::MakeSockets() {
  requests_ = zmq::socket_t(context_, zmq::socket_type::router);
  notifications_ = zmq::socket_t(context_, zmq::socket_type::pub);
  for (zmq::socket_t* socket : {&requests_, &notifications_}) {
    socket->set(zmq::sockopt::linger, kLinger);
    socket->set(zmq::sockopt::maxmsgsize, kMaxRequestBytes);
    if (gate_) gate_->Guard(*socket);
  }
  requests_.set(zmq::sockopt::sndhwm, kMaxUnread);
  requests_.set(zmq::sockopt::router_mandatory, true);  // so that Send knows who has gone
}

void LiveSockets::Bind(zmq::socket_t& socket, const std::string& address, int port) {
  try {
    socket.bind(Endpoint(address, std::to_string(port)));
  } catch (const zmq::error_t& error) {
    throw std::runtime_error(WhyNot(address + ":" + std::to_string(port), error));
  }
}

// The system chooses the first port; the one after it may be taken, then another try is made.
void LiveSockets::BindFreePair(const std::string& address) {
  constexpr int kAttempts = 100;
  for (int attempt = 1;; ++attempt) {
    MakeSockets();
    try {
      requests_.bind(Endpoint(address, "*"));
    } catch (const zmq::error_t& error) {
      throw std::runtime_error(WhyNot(address, error));
    }
    port_ = BoundPort(requests_);
    try {
      Bind(notifications_, address, port_ + 1);
      return;
    } catch (const std::runtime_error&) {
      if (attempt == kAttempts) throw;
    }
  }
}

void LiveSockets::Wait(std::chrono::milliseconds patience) {
  std::array<zmq::pollitem_t, 3> items = {{
      {nullptr, wake_.descriptor(), ZMQ_POLLIN, 0},
      {requests_.handle(), 0, ZMQ_POLLIN, 0},
      {gate_ ? gate_->socket().handle() : nullptr, wake_.descriptor(), ZMQ_POLLIN, 0},
  }};
  try {
    zmq::poll(items.data(), gate_ ? 3 : 2, patience);
  } catch (const zmq::error_t& error) {
    if (error.num() != EINTR) throw;
    return;
  }
  if (items[0].revents != 0) wake_.Reset();
  if (gate_ && items[2].revents != 0) gate_->Serve();
}

bool LiveSockets::Receive(ReceivedRequest& request) {
  while (ReceiveMessage(request)) {
    groot2::Parts& parts = request.parts;
    if (parts.size() < 2 || !parts[1].empty()) continue;  // from no client that awaits an answer
    request.client = std::move(parts[0]);
    parts.erase(parts.begin(), parts.begin() + 2);
    return true;
  }
  return false;
}

// The parts of a message come together.
bool LiveSockets::ReceiveMessage(ReceivedRequest& request) {
  request.parts.clear();
  zmq::message_t part;
  do {
    if (!requests_.recv(part, zmq::recv_flags::dontwait)) return false;
    request.parts.push_back(part.to_string());
  } while (part.more());
  request.may_control = !gate_ || std::string(part.gets("User-Id")) == CurveGate::kControl;
  return true;
}

SendResult LiveSockets::Send(const std::string& client, const groot2::Parts& parts) {
  constexpr auto kMore = zmq::send_flags::sndmore | zmq::send_flags::dontwait;
  try {
    if (!requests_.send(zmq::buffer(client), kMore)) return SendResult::kFull;
    requests_.send(zmq::message_t(), kMore);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool last = i + 1 == parts.size();
      requests_.send(zmq::buffer(parts[i]), last ? zmq::send_flags::dontwait : kMore);
    }
    return SendResult::kSent;
  } catch (const zmq::error_t&) {  // EHOSTUNREACH
    return SendResult::kGone;
  }
}

void LiveSockets::Publish(const groot2::Parts& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    notifications_.send(zmq::buffer(parts[i]),
                        last ? zmq::send_flags::none : zmq::send_flags::sndmore);
  }
}

}  // namespace coppice
