// What a recorder has called safe survives kill -9 at any moment.
#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <random>

#include "tests/bt_core/record/temporary_folder.h"
#include "tests/bt_core/record/whole_record.h"

namespace coppice {
namespace {

using Clock = std::chrono::steady_clock;

/// A recording program that is killed.
class Victim {
 public:
  explicit Victim(const std::string& record) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      execl(COPPICE_BINARY_DIR "/tests/bin/bt_core_record_victim", "victim", record.c_str(),
            static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    pipe_ = ends[0];
  }
  ~Victim() { close(pipe_); }

  /// Waits for a report of the victim until the deadline; true if one came.
  bool ReadReport(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd ready{pipe_, POLLIN, 0};
    if (left.count() <= 0 || poll(&ready, 1, static_cast<int>(left.count())) <= 0) return false;
    return read(pipe_, &safe_tick_, sizeof(safe_tick_)) == sizeof(safe_tick_);
  }

  /// Kills it, takes the reports that are left, and returns the newest tick that it called safe.
  std::uint64_t Kill() {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    while (read(pipe_, &safe_tick_, sizeof(safe_tick_)) == sizeof(safe_tick_)) {
    }
    return safe_tick_;
  }

 private:
  pid_t process_;
  int pipe_;
  std::uint64_t safe_tick_ = 0;
};

TEST(Recorder, LosesNothingThatItCalledSafeWhenItIsKilled) {
  std::mt19937 random(9);
  for (int round = 0; round < 200; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("run.coppice");
    Victim victim(path);
    ASSERT_TRUE(victim.ReadReport(Clock::now() + std::chrono::seconds(30)));
    const auto end = Clock::now() + std::chrono::microseconds(random() % 15000);
    while (victim.ReadReport(end)) {
    }
    const std::uint64_t safe = victim.Kill();

    const WholeRecord record = ReadRecord(path);
    EXPECT_TRUE(record.gaps.empty());
    EXPECT_TRUE(record.damages.empty());  // the end may be torn
    EXPECT_FALSE(record.closed);
    ASSERT_GE(record.numbers.size(), safe);
    for (std::size_t i = 0; i < record.numbers.size(); ++i) {
      ASSERT_EQ(record.numbers[i], i + 1);
    }
  }
}

}  // namespace
}  // namespace coppice
