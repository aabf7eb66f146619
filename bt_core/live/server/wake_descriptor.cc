#include "bt_core/live/server/wake_descriptor.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace coppice {

WakeDescriptor::WakeDescriptor() : descriptor_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
}

WakeDescriptor::~WakeDescriptor() { close(descriptor_); }

void WakeDescriptor::Wake() {
  if (woken_.exchange(true, std::memory_order_acq_rel)) return;
  eventfd_write(descriptor_, 1);
}

void WakeDescriptor::Reset() {
  eventfd_t count;
  eventfd_read(descriptor_, &count);
  woken_.exchange(false, std::memory_order_acq_rel);
}

}  // namespace coppice
