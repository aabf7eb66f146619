// Where to listen, as people write it: "127.0.0.1", "lo", "*" for every network.
#ifndef COPPICE_BT_CORE_LIVE_WEB_LOCAL_ADDRESS_H_
#define COPPICE_BT_CORE_LIVE_WEB_LOCAL_ADDRESS_H_

#include <string>

namespace coppice {

/// A numeric IPv4 or IPv6 address: that of an interface if it is the name of one, "0.0.0.0" for
/// "*". Anything else comes back as it is.
std::string LocalAddress(const std::string& address);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_WEB_LOCAL_ADDRESS_H_
