#include <gmock/gmock.h>

#include <csignal>
#include <future>
#include <iostream>

#include "bt_core/record/record_reader.h"
#include "tests/bt_core/cli/awaited_output.h"
#include "tests/bt_core/cli/fixture.h"
#include "tests/bt_core/live/robot.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

class RecordTest : public CliTest {
 protected:
  // 0 if it cannot be read yet.
  static std::uint64_t LastTick(const std::string& path) {
    Diagnostics diagnostics;
    const auto record = RecordReader::Open(path, diagnostics);
    return record ? record->last_tick() : 0;
  }
};

TEST_F(RecordTest, RecordsUntilItIsInterruptedAndClosesTheRecord) {
  Robot robot;
  robot.Tick(5);
  const std::string file = (folder_ / "run.coppice").string();
  AwaitedOutput errors(std::cerr);
  AwaitedOutput output(std::cout);
  auto verb = std::async(std::launch::async, [&] {
    return RunRecord({robot.endpoint(), "-o", file});
  });
  EXPECT_TRUE(errors.Await("connected"));
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (LastTick(file) < 5 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::yield();
  }
  std::raise(SIGINT);
  EXPECT_EQ(verb.get(), 0);
  EXPECT_THAT(output.text(), HasSubstr("run.coppice: 5 ticks"));
  Diagnostics diagnostics;
  const auto record = RecordReader::Open(file, diagnostics);
  ASSERT_TRUE(record) << diagnostics.ToString();
  EXPECT_TRUE(record->closed());
  EXPECT_EQ(record->last_tick(), 5u);
  EXPECT_EQ(record->gaps().size(), 0u);
  EXPECT_EQ(record->damages().size(), 0u);
}

TEST_F(RecordTest, EndsByItself) {
  const std::string file = (folder_ / "run.coppice").string();
  EXPECT_EQ(Run(RunRecord, {"127.0.0.1:1", "-o", file, "--seconds", "0"}), 1);  // saw no robot
}

TEST_F(RecordTest, NeverOverwritesAFile) {
  const std::string file = Write("precious.coppice", "x");
  EXPECT_EQ(Run(RunRecord, {"127.0.0.1:1", "-o", file}), 2);
  EXPECT_NE(err_, "");
}

TEST_F(RecordTest, NeedsARobotAndAFile) {
  EXPECT_EQ(Run(RunRecord, {"127.0.0.1:1"}), 2);
  EXPECT_EQ(Run(RunRecord, {"-o", "x"}), 2);
  EXPECT_EQ(Run(RunRecord, {"a:b", "-o", (folder_ / "y").string()}), 2);
  EXPECT_EQ(Run(RunRecord, {"a", "-o", "x", "--seconds", "-3"}), 2);
  EXPECT_EQ(Run(RunRecord, {"a", "-o", "x", "--max-file-mb", "many"}), 2);
}

}  // namespace
}  // namespace coppice
