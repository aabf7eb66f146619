// Loaded into a program (LD_PRELOAD) it is a disk that takes nothing before a file is there, whose
// name the variable COPPICE_TEST_DISK_READY has.
#include <unistd.h>

#include <cstdlib>

extern "C" int fsync(int /*file*/) {
  constexpr useconds_t kPause = 10'000;  // us
  const char* const ready = std::getenv("COPPICE_TEST_DISK_READY");
  while (ready && access(ready, F_OK) != 0) usleep(kPause);
  return 0;
}
