// Counts what each thread allocates. Linking counting_new.cc replaces operator new.
#ifndef COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_
#define COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_

#include <cstdint>

namespace coppice {

/// How often the calling thread has allocated so far.
std::uint64_t Allocations();

/// How many bytes it has allocated so far, less those that it has freed, as malloc rounds them.
std::int64_t BytesHeld();

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_COUNTING_NEW_H_
