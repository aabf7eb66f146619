// The entry that libFuzzer looks for; COPPICE_FUZZ_TARGET is a function of fuzz_targets.h.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/fuzz_targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  coppice::fuzz::COPPICE_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
