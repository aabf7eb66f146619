// A network of the test's own, in which there is this computer alone: what is announced in it, by
// real multicast, is heard by nobody else, and nobody else is heard.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_DISCOVERY_OWN_NETWORK_H_
#define COPPICE_TESTS_BT_CORE_LIVE_DISCOVERY_OWN_NETWORK_H_

#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstring>

namespace coppice {

/// For this thread and those that it starts, until the program ends. Who may not have one (without
/// the rights of root) stays in the network of the computer, on the loopback interface: there the
/// test meets robots of others, which it must not mind.
class OwnNetwork {
 public:
  OwnNetwork() { is_own_ = unshare(CLONE_NEWNET) == 0 && SetUp("lo"); }
  bool is_own() const { return is_own_; }

 private:
  static bool SetUp(const char* interface) {
    const int any = socket(AF_INET, SOCK_DGRAM, 0);
    ifreq request{};
    std::strncpy(request.ifr_name, interface, IFNAMSIZ - 1);
    bool good = ioctl(any, SIOCGIFFLAGS, &request) == 0;
    request.ifr_flags |= IFF_UP;
    good = good && ioctl(any, SIOCSIFFLAGS, &request) == 0;
    close(any);
    return good;
  }

  bool is_own_ = false;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_DISCOVERY_OWN_NETWORK_H_
