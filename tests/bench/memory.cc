#include "tests/bench/memory.h"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> bytes{0};
std::atomic<std::size_t> allocations{0};

void* Allocate(std::size_t size) {
  void* at = std::malloc(size);
  if (!at) throw std::bad_alloc();
  allocations.fetch_add(1, std::memory_order_relaxed);
  bytes.fetch_add(malloc_usable_size(at), std::memory_order_relaxed);
  return at;
}

void Free(void* at) {
  bytes.fetch_sub(malloc_usable_size(at), std::memory_order_relaxed);
  std::free(at);
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size); }
void* operator new[](std::size_t size) { return Allocate(size); }
void operator delete(void* at) noexcept { Free(at); }
void operator delete[](void* at) noexcept { Free(at); }
void operator delete(void* at, std::size_t) noexcept { Free(at); }
void operator delete[](void* at, std::size_t) noexcept { Free(at); }

namespace coppice::bench {

std::size_t BytesInUse() { return bytes; }

std::size_t Allocations() { return allocations; }

}  // namespace coppice::bench
