#include "bt_core/live/client/name_lookup.h"

#include <netdb.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cstring>
#include <mutex>
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

struct NameLookup::Shared {
  Shared() : done(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}
  ~Shared() {
    if (done >= 0) close(done);
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  void End(std::vector<NetworkAddress> found) {
    const std::lock_guard<std::mutex> lock(mutex);
    addresses = std::move(found);
    eventfd_write(done, 1);
  }

  const int done;
  std::mutex mutex;
  std::vector<NetworkAddress> addresses;
};

NameLookup::NameLookup(const std::string& host, const std::string& port)
    : shared_(std::make_shared<Shared>()) {
  const std::string name = WithoutBrackets(host);
  std::vector<NetworkAddress> numbers = Resolve(name, port, AI_NUMERICHOST);
  if (!numbers.empty()) {
    shared_->End(std::move(numbers));
    return;
  }
  try {
    std::thread([shared = shared_, name, port] { shared->End(Resolve(name, port, 0)); }).detach();
  } catch (const std::system_error&) {  // no thread now: perhaps the next time
    shared_->End({});
  }
}

int NameLookup::fd() const { return shared_->done; }

std::vector<NetworkAddress> NameLookup::Take() {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  return std::move(shared_->addresses);
}

}  // namespace coppice
