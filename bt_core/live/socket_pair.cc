#include "bt_core/live/socket_pair.h"

#include <stdexcept>
#include <utility>

namespace coppice {
namespace {

constexpr std::int64_t kMaxRequestBytes = 1 << 20;

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

SocketPair::SocketPair(const std::string& address, std::uint16_t port) {
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

void SocketPair::MakeSockets() {
  requests_ = zmq::socket_t(context_, zmq::socket_type::router);
  notifications_ = zmq::socket_t(context_, zmq::socket_type::pub);
  for (zmq::socket_t* socket : {&requests_, &notifications_}) {
    socket->set(zmq::sockopt::linger, 0);
    socket->set(zmq::sockopt::maxmsgsize, kMaxRequestBytes);
  }
}

void SocketPair::Bind(zmq::socket_t& socket, const std::string& address, int port) {
  try {
    socket.bind(Endpoint(address, std::to_string(port)));
  } catch (const zmq::error_t& error) {
    throw std::runtime_error(WhyNot(address + ":" + std::to_string(port), error));
  }
}

// The system chooses the first port; the one after it may be taken, then another try is made.
void SocketPair::BindFreePair(const std::string& address) {
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

bool SocketPair::Receive(std::vector<std::string>& parts) {
  try {
    do {
      ReceiveMessage(parts);
    } while (parts.size() < 2 || !parts[1].empty());  // not from a client that awaits an answer
    client_ = std::move(parts[0]);
    parts.erase(parts.begin(), parts.begin() + 2);
    return true;
  } catch (const zmq::error_t&) {  // the context is shutting down
    return false;
  }
}

void SocketPair::ReceiveMessage(std::vector<std::string>& parts) {
  parts.clear();
  zmq::message_t part;
  do {
    while (!ReceivePart(part)) {
    }
    parts.push_back(part.to_string());
  } while (part.more());
}

bool SocketPair::ReceivePart(zmq::message_t& part) {
  try {
    return requests_.recv(part).has_value();
  } catch (const zmq::error_t& error) {
    if (error.num() != EINTR) throw;
    return false;
  }
}

void SocketPair::Reply(const std::vector<std::string>& parts) {
  try {
    requests_.send(zmq::buffer(client_), zmq::send_flags::sndmore);
    requests_.send(zmq::message_t(), zmq::send_flags::sndmore);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const bool last = i + 1 == parts.size();
      requests_.send(zmq::buffer(parts[i]),
                     last ? zmq::send_flags::none : zmq::send_flags::sndmore);
    }
  } catch (const zmq::error_t&) {
    // The context is shutting down: Receive says so.
  }
}

}  // namespace coppice
