#include "bt_core/live/client/client_socket.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace coppice {
namespace {

constexpr char kDefaultPort[] = "1667";
constexpr int kReconnectPause = 50;         // ms
constexpr int kLargestMessage = 128 << 20;  // bytes; a frame is smaller

// A name of its own for each pair of sockets in the program.
std::string InnerAddress(const char* what) {
  static std::atomic<unsigned> count{0};
  return std::string("inproc://coppice-client-") + what + std::to_string(++count);
}

std::chrono::milliseconds Milliseconds(Duration duration) {
  return std::max(std::chrono::milliseconds(0),
                  std::chrono::ceil<std::chrono::milliseconds>(duration));
}

bool IsPort(const std::string& text) {
  unsigned port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return error == std::errc() && end == text.data() + text.size() && port > 0 && port < 65536;
}

}  // namespace

std::string AddressOf(const std::string& endpoint) {
  const std::size_t colon = endpoint.rfind(':');
  const std::string host = endpoint.substr(0, colon);
  const std::string port = colon == std::string::npos ? kDefaultPort : endpoint.substr(colon + 1);
  if (host.empty() || !IsPort(port) || host.find('/') != std::string::npos) {
    throw std::invalid_argument("\"" + endpoint +
                                "\" is no robot; expected HOST:PORT, such as localhost:1667");
  }
  return "tcp://" + host + ":" + port;
}

std::string NotificationsOf(const std::string& address) {
  const std::size_t colon = address.rfind(':');
  return address.substr(0, colon + 1) + std::to_string(std::stoi(address.substr(colon + 1)) + 1);
}

ClientBell::ClientBell(zmq::context_t& context)
    : in_(context, zmq::socket_type::pair), out_(context, zmq::socket_type::pair) {
  const std::string address = InnerAddress("bell-");
  out_.bind(address);
  in_.connect(address);
}

void ClientBell::Ring() {
  const std::lock_guard<std::mutex> lock(mutex_);
  static_cast<void>(in_.send(zmq::message_t(), zmq::send_flags::dontwait));
}

ClientSocket::ClientSocket(zmq::context_t& context, ClientBell& bell, const std::string& address,
                           const WatcherKeys* keys)
    : bell_(bell),
      socket_(context, zmq::socket_type::dealer),
      monitor_(context, zmq::socket_type::pair),
      published_(context, zmq::socket_type::sub) {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.set(zmq::sockopt::reconnect_ivl, kReconnectPause);
  socket_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(kLargestMessage));
  socket_.set(zmq::sockopt::ipv6, true);
  if (keys) {
    socket_.set(zmq::sockopt::curve_serverkey, keys->robot);
    socket_.set(zmq::sockopt::curve_publickey, keys->client.public_key);
    socket_.set(zmq::sockopt::curve_secretkey, keys->client.secret_key);
  }
  const std::string inner = InnerAddress("monitor-");
  constexpr int kEvents = ZMQ_EVENT_DISCONNECTED | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH |
                          ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                          ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL;
  if (zmq_socket_monitor(socket_.handle(), inner.c_str(), kEvents) != 0) throw zmq::error_t();
  monitor_.connect(inner);
  socket_.connect(address);
}

ClientSocket::~ClientSocket() { zmq_socket_monitor(socket_.handle(), nullptr, 0); }

void ClientSocket::Linger() {
  constexpr int kLongest = 100;  // ms
  socket_.set(zmq::sockopt::linger, kLongest);
}

ClientSocket::Event ClientSocket::Wait(Duration at_most) {
  zmq::pollitem_t items[] = {{socket_.handle(), 0, ZMQ_POLLIN, 0},
                             {bell_.out_.handle(), 0, ZMQ_POLLIN, 0},
                             {monitor_.handle(), 0, ZMQ_POLLIN, 0},
                             {published_.handle(), 0, ZMQ_POLLIN, 0}};
  zmq::poll(items, 4, Milliseconds(at_most));
  if ((items[0].revents | items[3].revents) & ZMQ_POLLIN) return Event::kMessage;
  if (items[1].revents & ZMQ_POLLIN) {
    zmq::message_t ring;
    while (bell_.out_.recv(ring, zmq::recv_flags::dontwait)) continue;
    return Event::kBell;
  }
  if (items[2].revents & ZMQ_POLLIN) return ReadMonitor() ? Event::kGone : Event::kTimeout;
  return Event::kTimeout;
}

// True if it says that there is no connection any more.
bool ClientSocket::ReadMonitor() {
  zmq::message_t event;
  zmq::message_t address;
  if (!monitor_.recv(event, zmq::recv_flags::dontwait)) return false;
  if (event.more()) static_cast<void>(monitor_.recv(address));
  std::uint16_t number = 0;
  if (event.size() < sizeof(number)) return false;
  std::memcpy(&number, event.data(), sizeof(number));
  switch (number) {
    case ZMQ_EVENT_DISCONNECTED:
    case ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL:
    case ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL:
    case ZMQ_EVENT_HANDSHAKE_FAILED_AUTH:
      problem_ = has_received_ ? "the connection is closed"
                               : std::string(
                                     "the robot closed the connection at once; perhaps it "
                                     "needs another token in ") +
                                     kTokenVariable;
      return true;
    default:
      return false;
  }
}

void ClientSocket::Listen(const std::string& address) {
  published_.set(zmq::sockopt::linger, 0);
  published_.set(zmq::sockopt::maxmsgsize, static_cast<std::int64_t>(kLargestMessage));
  published_.set(zmq::sockopt::ipv6, true);
  published_.set(zmq::sockopt::subscribe, "");
  published_.connect(address);
}

ClientSocket::Parts ClientSocket::Receive() {
  Parts parts = ReceiveFrom(socket_);
  has_received_ = has_received_ || !parts.empty();
  return parts.empty() ? ReceiveFrom(published_) : parts;
}

ClientSocket::Parts ClientSocket::ReceiveFrom(zmq::socket_t& socket) {
  Parts parts;
  zmq::message_t part;
  if (!socket.recv(part, zmq::recv_flags::dontwait)) return parts;
  parts.push_back(part.to_string());
  while (part.more()) {
    static_cast<void>(socket.recv(part));
    parts.push_back(part.to_string());
  }
  if (parts.front().empty()) parts.erase(parts.begin());
  return parts;
}

void ClientSocket::Send(const Parts& parts) {
  if (!socket_.send(zmq::message_t(), zmq::send_flags::sndmore | zmq::send_flags::dontwait)) return;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto flags = i + 1 == parts.size() ? zmq::send_flags::none : zmq::send_flags::sndmore;
    socket_.send(zmq::buffer(parts[i]), flags);
  }
}

}  // namespace coppice
