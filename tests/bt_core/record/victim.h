// A program that a test starts, listens to, and kills.
#ifndef COPPICE_TESTS_BT_CORE_RECORD_VICTIM_H_
#define COPPICE_TESTS_BT_CORE_RECORD_VICTIM_H_

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace coppice {

class Victim {
 public:
  using Clock = std::chrono::steady_clock;

  /// The program (a path) and its arguments; `output` is what is listened to: STDOUT_FILENO or
  /// STDERR_FILENO.
  Victim(std::vector<std::string> command, int output) {
    std::vector<char*> arguments;
    for (std::string& word : command) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("no process");
    if (process_ == 0) {
      dup2(ends[1], output);
      close(ends[0]);
      close(ends[1]);
      execv(arguments[0], arguments.data());
      _exit(127);
    }
    close(ends[1]);
    pipe_ = ends[0];
  }
  ~Victim() {
    Kill();
    close(pipe_);
  }
  Victim(const Victim&) = delete;
  Victim& operator=(const Victim&) = delete;

  /// Waits until it says something or the deadline has passed. False if it is silent, or has ended.
  bool Listen(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd ready{pipe_, POLLIN, 0};
    if (left.count() <= 0 || poll(&ready, 1, static_cast<int>(left.count())) <= 0) return false;
    return Read();
  }

  /// kill -9; then takes what is left in the pipe.
  void Kill() {
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    waitpid(std::exchange(process_, 0), nullptr, 0);
    while (Read()) continue;
  }

  /// All that it has said so far.
  const std::string& said() const { return said_; }

 private:
  bool Read() {
    char bytes[4096];
    const ssize_t count = read(pipe_, bytes, sizeof(bytes));
    if (count > 0) said_.append(bytes, static_cast<std::size_t>(count));
    return count > 0;
  }

  pid_t process_ = 0;
  int pipe_ = -1;
  std::string said_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_RECORD_VICTIM_H_
