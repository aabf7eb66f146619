// Addresses of a computer by its name, without waiting for them: a thread of its own asks, as a
// name server may take its time.
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_

#include <sys/socket.h>

#include <string>
#include <thread>
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
  /// Waits for the thread: for as long as a name server may take that does not answer.
  ~NameLookup();
  NameLookup(const NameLookup&) = delete;
  NameLookup& operator=(const NameLookup&) = delete;

  /// Readable when it has ended; -1 if that could not be.
  int fd() const { return done_; }
  /// When it has ended. None if nobody is called so.
  std::vector<NetworkAddress> Take();

 private:
  const int done_;
  std::vector<NetworkAddress> addresses_;  // the thread's until it has ended
  std::thread thread_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_NAME_LOOKUP_H_
