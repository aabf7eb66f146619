// The heap, counted by this program's operator new.
#ifndef COPPICE_TESTS_BENCH_MEMORY_H_
#define COPPICE_TESTS_BENCH_MEMORY_H_

#include <cstddef>

namespace coppice::bench {

/// What is allocated now, as malloc rounds it.
std::size_t BytesInUse();

/// How often something was allocated since the program started, in all threads.
std::size_t Allocations();

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_MEMORY_H_
