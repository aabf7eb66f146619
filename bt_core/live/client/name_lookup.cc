#include "bt_core/live/client/name_lookup.h"

#include <netdb.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

namespace coppice {
namespace {

std::vector<NetworkAddress> Resolve(const std::string& host, const std::string& port, int flags) {
  addrinfo hints = {};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  std::vector<NetworkAddress> addresses;
  if (getaddrinfo(host.c_str(), port.c_str(), &hints, &found) != 0) return addresses;
  for (const addrinfo* at = found; at; at = at->ai_next) {
    NetworkAddress address;
    address.size = at->ai_addrlen;
    std::memcpy(&address.address, at->ai_addr, at->ai_addrlen);
    addresses.push_back(address);
  }
  freeaddrinfo(found);
  return addresses;
}

std::string WithoutBrackets(const std::string& host) {
  const bool has_brackets = host.size() > 2 && host.front() == '[' && host.back() == ']';
  return has_brackets ? host.substr(1, host.size() - 2) : host;
}

}  // namespace

NameLookup::NameLookup(const std::string& host, const std::string& port)
    : done_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  const std::string name = WithoutBrackets(host);
  addresses_ = Resolve(name, port, AI_NUMERICHOST);
  if (!addresses_.empty()) {
    eventfd_write(done_, 1);
    return;
  }
  try {
    thread_ = std::thread([this, name, port] {
      pthread_setname_np(pthread_self(), "coppice_lookup");
      addresses_ = Resolve(name, port, 0);
      eventfd_write(done_, 1);
    });
  } catch (const std::system_error&) {  // no thread now: perhaps the next time
    eventfd_write(done_, 1);
  }
}

NameLookup::~NameLookup() {
  if (thread_.joinable()) thread_.join();
  if (done_ >= 0) close(done_);
}

std::vector<NetworkAddress> NameLookup::Take() {
  if (thread_.joinable()) thread_.join();
  return std::move(addresses_);
}

}  // namespace coppice
