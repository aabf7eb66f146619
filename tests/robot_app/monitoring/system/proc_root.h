// A folder that stands for "/" of a computer whose values a test chooses.
#ifndef COPPICE_TESTS_ROBOT_APP_MONITORING_SYSTEM_PROC_ROOT_H_
#define COPPICE_TESTS_ROBOT_APP_MONITORING_SYSTEM_PROC_ROOT_H_

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::monitoring {

class ProcRoot {
 public:
  explicit ProcRoot(const std::string& name) : path_(processes::Temporary(name)) {
    std::filesystem::remove_all(path_);
  }

  const std::string& path() const { return path_; }
  void Write(const std::string& file, const std::string& text) const {
    const std::filesystem::path whole = path_ + file;
    std::filesystem::create_directories(whole.parent_path());
    std::ofstream(whole) << text;
  }

  // In ticks since the start.
  void WriteCpu(int busy, int idle) const {
    Write("/proc/stat", "cpu  " + std::to_string(busy) + " 0 0 " + std::to_string(idle) +
                            " 0 0 0 0 0 0\ncpu0 1 2 3 4 5 6 7 8 9 10\nintr 5\n");
  }
  // In kB.
  void WriteMemory(int total, int available) const {
    Write("/proc/meminfo", "MemTotal:       " + std::to_string(total) +
                               " kB\nMemFree:  1 kB\nMemAvailable:   " + std::to_string(available) +
                               " kB\nBuffers: 7 kB\n");
  }
  void WriteInterface(const std::string& name, long received, long sent, int errors,
                      int drops) const {
    Write("/proc/net/dev",
          "Inter-|   Receive                                                |  Transmit\n"
          " face |bytes    packets errs drop fifo frame compressed multicast|bytes ...\n"
          "    lo:     100       1    0    0    0     0          0         0      100 1 0 0 0 0 0 "
          "0\n  " +
              name + ": " + std::to_string(received) + " 10 " + std::to_string(errors) + " " +
              std::to_string(drops) + " 0 0 0 0 " + std::to_string(sent) + " 20 0 0 0 0 0 0\n");
  }
  // Times in ticks, memory in pages.
  void WriteProcess(int pid, int user, int system, int threads, int pages) const {
    const std::string folder = "/proc/" + std::to_string(pid);
    Write(folder + "/stat", std::to_string(pid) + " (a (b) c) S 1 2 3 4 5 6 7 8 9 10 " +
                                std::to_string(user) + " " + std::to_string(system) + " 0 0 20 0 " +
                                std::to_string(threads) + " 0 12345 99999 " +
                                std::to_string(pages) + " 18446744073709551615 1 2\n");
    Write(folder + "/fd/0", "");
    Write(folder + "/fd/1", "");
    Write(folder + "/fd/2", "");
  }

 private:
  std::string path_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_TESTS_ROBOT_APP_MONITORING_SYSTEM_PROC_ROOT_H_
