#include "tests/editor/files/dying_calls.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace {

int left = 0;  // 0: it does not die

bool IsLast() { return left > 0 && --left == 0; }

void Die() { kill(getpid(), SIGKILL); }

template <class Call>
auto Counted(const Call& call) {
  if (IsLast()) Die();
  const auto result = call();
  if (IsLast()) Die();
  return result;
}

}  // namespace

namespace coppice {

void DieAtDiskCall(int count) { left = count; }

}  // namespace coppice

// In the place of those of the C library, for everything in this program.
extern "C" {

ssize_t write(int file, const void* bytes, size_t size) {
  if (IsLast()) {
    syscall(SYS_write, file, bytes, size / 2);
    Die();
  }
  const ssize_t written = syscall(SYS_write, file, bytes, size);
  if (IsLast()) Die();
  return written;
}

int fsync(int file) {
  return Counted([=] { return static_cast<int>(syscall(SYS_fsync, file)); });
}

int rename(const char* from, const char* to) noexcept {
  return Counted(
      [=] { return static_cast<int>(syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to)); });
}

int unlink(const char* path) noexcept {
  return Counted([=] { return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, 0)); });
}

int remove(const char* path) noexcept {
  return Counted([=] {
    const auto remove_as = [=](int flags) {
      return static_cast<int>(syscall(SYS_unlinkat, AT_FDCWD, path, flags));
    };
    return remove_as(0) == 0 ? 0 : remove_as(AT_REMOVEDIR);
  });
}
}
