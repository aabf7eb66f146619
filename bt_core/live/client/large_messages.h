// Room for large messages, of all connections of a program together: each robot that it follows may
// send one of the largest kind, but not all of them at the same time.
//
//   LargeMessages room;                   // of a connection
//   if (!room.Hold(bytes_so_far)) ...     // no room for it beside those of others: hang up
#ifndef COPPICE_BT_CORE_LIVE_CLIENT_LARGE_MESSAGES_H_
#define COPPICE_BT_CORE_LIVE_CLIENT_LARGE_MESSAGES_H_

#include <atomic>
#include <cstddef>

namespace coppice {

/// For one thread; others may have their own.
class LargeMessages {
 public:
  static constexpr std::size_t kAll = 65 << 20;   ///< bytes: one of the largest kind
  static constexpr std::size_t kSmall = 4 << 20;  ///< bytes: up to this, there is always room

  LargeMessages() = default;
  ~LargeMessages() { Hold(0); }
  LargeMessages(const LargeMessages&) = delete;
  LargeMessages& operator=(const LargeMessages&) = delete;

  /// From now on so many bytes; false if there is no room for them: then it is what it was.
  bool Hold(std::size_t bytes) {
    const std::size_t wanted = bytes > kSmall ? bytes : 0;
    const std::size_t before = all_.fetch_add(wanted - held_);  // unsigned: also backwards
    if (wanted > held_ && before + (wanted - held_) > kAll) {
      all_.fetch_sub(wanted - held_);
      return false;
    }
    held_ = wanted;
    return true;
  }

 private:
  static inline std::atomic<std::size_t> all_{0};
  std::size_t held_ = 0;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_CLIENT_LARGE_MESSAGES_H_
