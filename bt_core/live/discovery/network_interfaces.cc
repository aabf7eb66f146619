#include "bt_core/live/discovery/network_interfaces.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <cstring>
#include <memory>

namespace coppice {
namespace {

Ipv4 AddressOf(const sockaddr& address) {
  Ipv4 bytes{};
  std::memcpy(bytes.data(), &reinterpret_cast<const sockaddr_in&>(address).sin_addr, bytes.size());
  return bytes;
}

bool IsUsable(const ifaddrs& entry) {
  const unsigned int ways = IFF_MULTICAST | IFF_LOOPBACK;
  return entry.ifa_addr && entry.ifa_netmask && entry.ifa_addr->sa_family == AF_INET &&
         (entry.ifa_flags & IFF_UP) != 0 && (entry.ifa_flags & ways) != 0;
}

bool IsMeant(const NetworkInterface& one, const std::string& address) {
  if (address == "*" || address == "0.0.0.0" || address == one.name) return true;
  Ipv4 wanted{};
  if (inet_pton(AF_INET, address.c_str(), wanted.data()) != 1) return false;
  return wanted == one.address || (wanted[0] == 127 && one.address[0] == 127);
}

}  // namespace

bool NetworkInterface::Reaches(const Ipv4& other) const {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (((address[i] ^ other[i]) & mask[i]) != 0) return false;
  }
  return true;
}

std::vector<NetworkInterface> InterfacesOf(const std::string& address) {
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return {};
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, &freeifaddrs);
  std::vector<NetworkInterface> found;
  for (const ifaddrs* at = first; at; at = at->ifa_next) {
    if (!IsUsable(*at)) continue;
    const NetworkInterface one{at->ifa_name, AddressOf(*at->ifa_addr), AddressOf(*at->ifa_netmask)};
    const bool is_there = std::any_of(found.begin(), found.end(), [&](const NetworkInterface& has) {
      return has.name == one.name;
    });
    if (!is_there && IsMeant(one, address)) found.push_back(one);
  }
  return found;
}

}  // namespace coppice
