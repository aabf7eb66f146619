// What `coppice record` has written survives kill -9 at any moment. Every repetition
// (--gtest_repeat=10) takes other moments.
#include <gtest/gtest.h>

#include <random>
#include <thread>

#include "tests/bt_core/live/robot.h"
#include "tests/bt_core/record/victim.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using Clock = Victim::Clock;

// How far the record goes that is being written; 0 if it cannot be read yet.
std::uint64_t LastTick(const std::string& path) {
  Diagnostics diagnostics;
  const auto record = RecordReader::Open(path, diagnostics);
  return record ? record->last_tick() : 0;
}

TEST(RecordVerb, LosesNothingThatWasInTheFileWhenItIsKilled) {
  static std::mt19937 random(7);
  Robot robot;
  robot.StartTicking();
  for (int round = 0; round < 20; ++round) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("run.coppice");
    Victim victim({BinaryFolder() + "/bin/coppice", "record", robot.endpoint(), "-o", path},
                  STDERR_FILENO);
    const bool is_young = round % 4 == 0;  // it is killed while it begins
    const auto deadline = Clock::now() + std::chrono::seconds(30);
    while (!is_young && LastTick(path) == 0 && Clock::now() < deadline) std::this_thread::yield();
    const auto end = Clock::now() + std::chrono::microseconds(random() % 60000);
    std::uint64_t seen = LastTick(path);
    while (Clock::now() < end) seen = LastTick(path);
    victim.Kill();

    EXPECT_TRUE(is_young || seen > 0) << victim.said();
    if (seen == 0 && LastTick(path) == 0) continue;
    const WholeRecord record = ReadRecord(path);
    EXPECT_TRUE(record.gaps.empty());
    EXPECT_TRUE(record.damages.empty());  // the end may be torn
    EXPECT_FALSE(record.closed);
    ASSERT_FALSE(record.numbers.empty());
    EXPECT_EQ(record.numbers.front(), 1U) << "the robot has kept all of its past";
    EXPECT_GE(record.numbers.back(), seen);
    for (std::size_t i = 1; i < record.numbers.size(); ++i) {
      ASSERT_EQ(record.numbers[i], record.numbers[i - 1] + 1);
    }
  }
}

}  // namespace
}  // namespace coppice
