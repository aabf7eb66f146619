// Ends a poll(2) from another thread. Many wakes before the poll are one.
#ifndef COPPICE_BT_CORE_LIVE_SERVER_WAKE_DESCRIPTOR_H_
#define COPPICE_BT_CORE_LIVE_SERVER_WAKE_DESCRIPTOR_H_

#include <atomic>

namespace coppice {

class WakeDescriptor {
 public:
  /// Throws std::system_error if the system has no descriptors left.
  WakeDescriptor();
  ~WakeDescriptor();
  WakeDescriptor(const WakeDescriptor&) = delete;
  WakeDescriptor& operator=(const WakeDescriptor&) = delete;

  /// Any thread. Costs a system call only if there was none since the last Reset.
  void Wake();
  /// The polling thread, before it looks at what there is to do.
  void Reset();
  /// Readable when somebody has woken.
  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
  std::atomic<bool> woken_{false};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_SERVER_WAKE_DESCRIPTOR_H_
