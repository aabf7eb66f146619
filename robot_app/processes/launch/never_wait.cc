#include "robot_app/processes/launch/never_wait.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <iostream>
#include <string>

namespace coppice::robot::processes {
namespace {

// O_NONBLOCK belongs to what was opened, with all who share it: so a terminal or a pipe is opened
// once more. A socket cannot be; it is of one program and its children.
void NeverWaitFor(int file) {
  struct stat status {};
  if (fstat(file, &status) != 0 || S_ISREG(status.st_mode)) return;
  if (S_ISSOCK(status.st_mode)) {
    fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK);
    return;
  }
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  const int anew = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (anew < 0) return;  // of another user, or nobody is at its other end
  dup2(anew, file);
  close(anew);
}

}  // namespace

void NeverWaitForReaders() {
  NeverWaitFor(STDOUT_FILENO);
  NeverWaitFor(STDERR_FILENO);
}

void GoOnAfterLoss() {
  std::cout.clear();
  std::cerr.clear();
}

}  // namespace coppice::robot::processes
