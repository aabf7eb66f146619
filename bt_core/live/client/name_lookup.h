// Addresses of a computer by its name, without waiting for them: a thread of its own asks, as a
// name server may take its time.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_

#include <sys/socket.h>

#include <memory>
#include <string>
#include <vector>

namespace coppice {

struct NetworkAddress {
  sockaddr_storage address = {};
  socklen_t size = 0;
};

class NameLookup {
 public:
  /// Begins. `host`: a name or an address, IPv6 with or without brackets.
  NameLookup(const std::string& host, const std::string& port);

  /// Readable when it has ended; -1 if that could not be.
  int fd() const;
  /// When it has ended. None if nobody is called so.
  std::vector<NetworkAddress> Take();

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;  // the thread may outlive this
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_
