// The networks of this computer.
#ifndef COPPICE_BT_CORE_LIVE_DISCOVERY_NETWORK_INTERFACES_H_
#define COPPICE_BT_CORE_LIVE_DISCOVERY_NETWORK_INTERFACES_H_

#include <string>
#include <vector>

#include "bt_core/live/discovery/robot_messages.h"

namespace coppice {

struct NetworkInterface {
  std::string name;  ///< "eth0"
  Ipv4 address{};
  Ipv4 mask{};

  /// Whether somebody with that address is in this network, and not behind a router.
  bool Reaches(const Ipv4& other) const;
  bool operator==(const NetworkInterface& other) const {
    return name == other.name && address == other.address && mask == other.mask;
  }
};

/// Those that are up and have an IPv4 address, the first one if there are several, and of which
/// listening at `address` is: "*" all, "lo" or "127.0.0.1" this computer alone, or one by its name
/// or address.
std::vector<NetworkInterface> InterfacesOf(const std::string& address);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_DISCOVERY_NETWORK_INTERFACES_H_
