// A socket in one network of this computer, to the group of all that know multicast DNS. Included
// by .cc files only. One thread.
//
//   MulticastSocket socket(context, interface, MulticastSocket::Kind::kAsks, handler);
//   socket.SendToAll(QuestionMessage(id));
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SOCKET_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SOCKET_H_

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "bt_core/live/discovery/network_interfaces.h"

namespace coppice {

class MulticastSocket {
 public:
  using Endpoint = boost::asio::ip::udp::endpoint;
  static constexpr std::uint16_t kPort = 5353;

  enum class Kind : std::uint8_t {
    kAsks,    ///< has a port of its own, and hears answers to it alone
    kAnswers  ///< hears what is said to all, and nothing else
  };
  /// Gets what somebody in this network says, from where.
  using Handler = std::function<void(std::string_view message, const Endpoint& from)>;

  /// Hears when it returns. Throws boost::system::system_error if that cannot be.
  MulticastSocket(boost::asio::io_context& context, NetworkInterface interface, Kind kind,
                  Handler handler);

  const NetworkInterface& interface() const { return interface_; }
  /// False when the network has gone.
  bool is_good() const { return is_good_; }

  /// From now on it hears so many messages, then no more: nobody keeps it busy.
  void Hear(int most);

  void SendToAll(const std::string& message);
  void SendTo(const std::string& message, const Endpoint& to);

 private:
  void Receive();
  bool IsNear() const;

  const NetworkInterface interface_;
  const Handler handler_;
  boost::asio::ip::udp::socket socket_;
  std::array<char, 9000> bytes_;  // RFC 6762, 17
  Endpoint from_;
  int left_ = 0;  // messages that it still hears
  bool receives_ = false;
  bool is_good_ = true;
  const std::shared_ptr<int> life_ = std::make_shared<int>();  // what was heard may come after it
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_MULTICAST_SOCKET_H_
