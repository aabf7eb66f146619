#include "robot_app/common/limits/run_apart.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>

namespace coppice::robot {
namespace {

void Limit(int resource, std::size_t most) {
  const rlimit limit{most, most};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

[[noreturn]] void RunInCopy(const std::function<int()>& run, const ApartLimits& limits) noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // A crash ends the copy as one, whatever this program (or a sanitizer) does at its own.
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) signal(crash, SIG_DFL);
  Limit(RLIMIT_CORE, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadows are data, too
  if (limits.memory > 0) Limit(RLIMIT_DATA, limits.memory);
#endif
  alarm(static_cast<unsigned>(limits.patience.count()));
  const int result = run();
  std::cout.flush();
  std::fflush(nullptr);
  _exit(result);
}

std::string WordsFor(int signal, const ApartLimits& limits) {
  if (signal == SIGALRM)
    return "took longer than " + std::to_string(limits.patience.count()) + " s";
  return "crashed (signal " + std::to_string(signal) + ")";
}

}  // namespace

Expected<int> RunApart(const std::function<int()>& run, const ApartLimits& limits) {
  std::cout.flush();
  std::fflush(nullptr);  // or the copy would say it again
  const pid_t pid = fork();
  if (pid < 0) return Problem{std::string("cannot be tried: ") + std::strerror(errno)};
  if (pid == 0) RunInCopy(run, limits);
  int status = 0;
  while (waitpid(pid, &status, 0) < 0) {
    if (errno != EINTR) return Problem{std::string("cannot be tried: ") + std::strerror(errno)};
  }
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  return Problem{WordsFor(WTERMSIG(status), limits)};
}

}  // namespace coppice::robot
