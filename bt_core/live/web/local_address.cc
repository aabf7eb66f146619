#include "bt_core/live/web/local_address.h"

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>

#include <memory>

namespace coppice {

std::string LocalAddress(const std::string& address) {
  if (address == "*") return "0.0.0.0";
  ifaddrs* first = nullptr;
  if (getifaddrs(&first) != 0) return address;
  const std::unique_ptr<ifaddrs, void (*)(ifaddrs*)> all(first, &freeifaddrs);
  for (const ifaddrs* at = first; at; at = at->ifa_next) {
    if (!at->ifa_addr || at->ifa_addr->sa_family != AF_INET || address != at->ifa_name) continue;
    char text[INET_ADDRSTRLEN];
    const auto* const found = reinterpret_cast<const sockaddr_in*>(at->ifa_addr);
    if (inet_ntop(AF_INET, &found->sin_addr, text, sizeof(text))) return text;
  }
  return address;
}

}  // namespace coppice
