// A ring of bytes between one writing and one reading thread, without locks. Memory is taken once.
#ifndef COPPICE_BT_CORE_RECORD_BYTE_RING_H_
#define COPPICE_BT_CORE_RECORD_BYTE_RING_H_

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice {

class ByteRing {
 public:
  explicit ByteRing(std::size_t capacity) : bytes_(capacity) {}

  /// Writing thread: puts in all bytes, or none and returns false if there is no room.
  bool Push(const std::uint8_t* bytes, std::size_t size);

  /// Reading thread: appends everything that is in the ring and takes it out.
  void PopAll(std::vector<std::uint8_t>& out);

  /// Any thread: how many bytes were in it a moment ago.
  std::size_t size() const {
    return pushed_.load(std::memory_order_acquire) - popped_.load(std::memory_order_acquire);
  }
  std::size_t capacity() const { return bytes_.size(); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::atomic<std::size_t> pushed_{0};  // ever
  std::atomic<std::size_t> popped_{0};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_RECORD_BYTE_RING_H_
