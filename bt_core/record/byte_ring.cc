#include "bt_core/record/byte_ring.h"

#include <algorithm>

namespace coppice {

bool ByteRing::Push(const std::uint8_t* bytes, std::size_t size) {
  const std::size_t pushed = pushed_.load(std::memory_order_relaxed);
  if (size > capacity() - (pushed - popped_.load(std::memory_order_acquire))) return false;
  const std::size_t start = pushed % capacity();
  const std::size_t first = std::min(size, capacity() - start);
  std::copy_n(bytes, first, bytes_.data() + start);
  std::copy_n(bytes + first, size - first, bytes_.data());
  pushed_.store(pushed + size, std::memory_order_release);
  return true;
}

void ByteRing::PopAll(std::vector<std::uint8_t>& out) {
  const std::size_t popped = popped_.load(std::memory_order_relaxed);
  const std::size_t size = pushed_.load(std::memory_order_acquire) - popped;
  const std::size_t start = popped % capacity();
  const std::size_t first = std::min(size, capacity() - start);
  const std::uint8_t* const bytes = bytes_.data();
  out.insert(out.end(), bytes + start, bytes + start + first);
  out.insert(out.end(), bytes, bytes + (size - first));
  popped_.store(popped + size, std::memory_order_release);
}

}  // namespace coppice
