#include "bt_core/live/discovery/multicast_socket.h"

#include <netinet/in.h>
#include <sys/socket.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/unicast.hpp>
#include <utility>

namespace coppice {
namespace {

namespace asio = boost::asio;
using asio::ip::address_v4;
using boost::system::error_code;

constexpr int kHops = 255;  // RFC 6762, 11: a router would make it less

address_v4 Group() { return address_v4({224, 0, 0, 251}); }

// A socket that hears a group hears it in every network that anybody of this computer listens to,
// if it is not told to leave that.
void HearOwnNetworkOnly(asio::ip::udp::socket& socket) {
  const int no = 0;
  setsockopt(socket.native_handle(), IPPROTO_IP, IP_MULTICAST_ALL, &no, sizeof(no));
}

}  // namespace

MulticastSocket::MulticastSocket(asio::io_context& context, NetworkInterface interface, Kind kind,
                                 Handler handler)
    : interface_(std::move(interface)), handler_(std::move(handler)), socket_(context) {
  const address_v4 own(interface_.address);
  socket_.open(asio::ip::udp::v4());
  socket_.non_blocking(true);
  HearOwnNetworkOnly(socket_);
  if (kind == Kind::kAnswers) {
    socket_.set_option(asio::socket_base::reuse_address(true));
    socket_.bind({Group(), kPort});
    socket_.set_option(asio::ip::multicast::join_group(Group(), own));
  } else {
    socket_.bind({own, 0});
  }
  socket_.set_option(asio::ip::multicast::outbound_interface(own));
  socket_.set_option(asio::ip::multicast::hops(kHops));
  socket_.set_option(asio::ip::unicast::hops(kHops));
}

void MulticastSocket::Hear(int most) {
  left_ = most;
  if (!receives_) Receive();
}

void MulticastSocket::Receive() {
  receives_ = left_ > 0 && is_good_;
  if (!receives_) return;
  --left_;
  socket_.async_receive_from(
      asio::buffer(bytes_), from_,
      [this, life = std::weak_ptr<int>(life_)](error_code error, std::size_t size) {
        if (life.expired()) return;
        if (error) {
          is_good_ = false;
        } else if (IsNear()) {
          handler_({bytes_.data(), size}, from_);
        }
        Receive();
      });
}

bool MulticastSocket::IsNear() const {
  return from_.address().is_v4() && interface_.Reaches(from_.address().to_v4().to_bytes());
}

void MulticastSocket::SendToAll(const std::string& message) { SendTo(message, {Group(), kPort}); }

// Who waits for it asks again.
void MulticastSocket::SendTo(const std::string& message, const Endpoint& to) {
  error_code lost;
  socket_.send_to(asio::buffer(message), to, 0, lost);
}

}  // namespace coppice
