// Counts the allocations of each thread. Linking counting_new.cc replaces operator new.
#ifndef COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_
#define COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_

#include <cstdint>

namespace coppice {

/// How often the calling thread has allocated so far.
std::uint64_t Allocations();

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_
