#include "robot_app/common/limits/largest_allocation.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <new>

// Sanitizers have an operator new of their own, with limits of their own.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

void* Allocate(std::size_t size) {
  if (void* const memory = std::malloc(std::max<std::size_t>(size, 1))) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  if (size > coppice::robot::kLargestAllocation) throw std::bad_alloc();
  return Allocate(size);
}
void* operator new[](std::size_t size) { return Allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace coppice::robot {

void LimitMemory(std::size_t bytes) {
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace coppice::robot

#else

namespace coppice::robot {

void LimitMemory(std::size_t) {}  // shadows of the memory are data, too

}  // namespace coppice::robot

#endif
