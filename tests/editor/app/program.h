// Runs coppice-edit as a user does, and ends it.
#ifndef COPPICE_TESTS_EDITOR_APP_PROGRAM_H_
#define COPPICE_TESTS_EDITOR_APP_PROGRAM_H_

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace coppice::editor {

/// Looks again and again until it is true, or false after the deadline.
inline bool WaitFor(const std::function<bool()>& condition, std::chrono::milliseconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    ::usleep(5000);
  }
  return true;
}

class StartedProgram {
 public:
  /// `environment` is added to that of the test; its standard error goes to a file.
  StartedProgram(std::vector<std::string> arguments, std::vector<std::string> environment,
                 const std::string& error_file) {
    pid_ = ::fork();
    if (pid_ != 0) return;
    const int file = ::open(error_file.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
    ::dup2(file, 2);
    for (std::string& setting : environment) {
      const std::size_t equals = setting.find('=');
      if (equals == std::string::npos) ::unsetenv(setting.c_str());
      if (equals != std::string::npos) ::putenv(setting.data());
    }
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    ::execvp(argv[0], argv.data());
    ::_exit(127);
  }
  ~StartedProgram() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  void Signal(int number) const { ::kill(pid_, number); }

  /// The exit code, or -1 if it does not end in time or ends by a signal.
  int Wait(std::chrono::milliseconds longest) {
    int status = 0;
    const bool ended = WaitFor([&] { return ::waitpid(pid_, &status, WNOHANG) == pid_; }, longest);
    if (!ended) return -1;
    pid_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t pid_ = 0;
};

inline std::string ReadFile(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_APP_PROGRAM_H_
