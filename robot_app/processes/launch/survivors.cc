#include "robot_app/processes/launch/survivors.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace coppice::robot::processes {
namespace {

namespace fs = std::filesystem;

constexpr Duration kPause = std::chrono::milliseconds(10);

std::string ReadFile(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// A zombie has no environment any more, so it is not found.
bool IsOwned(const std::string& environment, const std::string& owned) {
  const std::string wanted = std::string(kOwnerVariable) + "=" + owned;
  std::istringstream variables(environment);
  std::string variable;
  while (std::getline(variables, variable, '\0')) {
    if (variable.compare(0, wanted.size(), wanted) == 0) return true;
  }
  return false;
}

}  // namespace

// The end is marked, so that no name is the beginning of another one.
std::string OwnedName(const std::string& owner, const std::string& process) {
  return owner + ":" + process + ":";
}

std::vector<int> FindOwned(const std::string& owned) {
  std::vector<int> found;
  std::error_code error;
  for (fs::directory_iterator entry("/proc", error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename();
    if (!std::isdigit(static_cast<unsigned char>(name.front()))) continue;
    const int pid = std::stoi(name);
    if (pid == getpid()) continue;
    if (IsOwned(ReadFile(entry->path() / "environ"), owned)) found.push_back(pid);
  }
  return found;
}

Expected<int> BecomeOnlyOne(const std::string& file, Duration deadline) {
  const auto failed = [&](const char* what) {
    return Problem{std::string("cannot ") + what + " " + file + ": " + std::strerror(errno)};
  };
  const int lock = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock < 0) return failed("open");
  const auto end = std::chrono::steady_clock::now() + deadline;
  while (flock(lock, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) return failed("lock");
    if (std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    close(lock);
    const int other = std::atoi(ReadFile(file).c_str());
    return other > 0 ? other : -1;
  }
  const std::string pid = std::to_string(getpid());
  if (ftruncate(lock, 0) != 0 || write(lock, pid.data(), pid.size()) < 0) return failed("write");
  return 0;
}

int KillOwned(const std::string& owned, Duration deadline) {
  std::vector<int> living = FindOwned(owned);
  const int count = static_cast<int>(living.size());
  const auto give_up = std::chrono::steady_clock::now() + deadline;
  while (!living.empty()) {
    if (std::chrono::steady_clock::now() > give_up) return -1;
    for (const int pid : living) kill(pid, SIGKILL);
    std::this_thread::sleep_for(kPause);
    living = FindOwned(owned);
  }
  return count;
}

}  // namespace coppice::robot::processes
