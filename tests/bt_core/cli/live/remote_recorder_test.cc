#include "bt_core/cli/live/remote_recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/record/record_reader.h"
#include "tests/bt_core/live/cut_line.h"
#include "tests/bt_core/live/robot.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::SizeIs;

class RemoteRecorderTest : public ::testing::Test {
 protected:
  // Waits until so many ticks are in the record.
  static bool Await(const RemoteRecorder& recorder, std::uint64_t ticks) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (recorder.counts().ticks < ticks) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::yield();
    }
    return true;
  }
  static bool AwaitLive(const RemoteRecorder& recorder, bool is_live) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (recorder.connection().is_live != is_live) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      std::this_thread::yield();
    }
    return true;
  }

  std::unique_ptr<RecordReader> Open(const std::string& name) {
    Diagnostics diagnostics;
    auto record = RecordReader::Open(folder_.Path(name), diagnostics);
    EXPECT_TRUE(record) << diagnostics.ToString();
    return record;
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.Path("run.coppice");
};

TEST_F(RemoteRecorderTest, ANewRunOfTheRobotIsAnotherRecord) {
  RemoteRecorder recorder(path_, {});
  auto robot = std::make_unique<Robot>();
  const std::uint16_t port = robot->port();
  auto client = std::make_unique<LiveClient>(robot->endpoint(), recorder);
  robot->Tick(10);
  ASSERT_TRUE(Await(recorder, 10));
  robot.reset();
  ASSERT_TRUE(AwaitLive(recorder, false));
  robot = std::make_unique<Robot>(Robot::WithPort(port));
  robot->Tick(7);
  ASSERT_TRUE(Await(recorder, 17));
  client.reset();
  recorder.Close();
  EXPECT_EQ(recorder.error(), "");
  EXPECT_EQ(recorder.counts().runs, 2u);
  EXPECT_EQ(recorder.counts().lost_ticks, 0u);
  const auto first = Open("run.coppice");
  const auto second = Open("run.run2.coppice");
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->last_tick(), 10u);
  EXPECT_TRUE(first->closed());
  EXPECT_EQ(second->last_tick(), 7u);
  EXPECT_TRUE(second->closed());
  EXPECT_NE(first->tree().info.run, second->tree().info.run);
}

TEST_F(RemoteRecorderTest, GoesOnWithoutAHoleWhenTheLineWasCut) {
  RemoteRecorder recorder(path_, {});
  Robot robot;
  CutLine line(robot.port());
  auto client = std::make_unique<LiveClient>(line.endpoint(), recorder);
  robot.Tick(10);
  ASSERT_TRUE(Await(recorder, 10));
  line.Cut();
  ASSERT_TRUE(AwaitLive(recorder, false));
  robot.Tick(500);
  line.Mend();
  ASSERT_TRUE(Await(recorder, 510));
  client.reset();
  recorder.Close();
  const auto record = Open("run.coppice");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->last_tick(), 510u);
  EXPECT_THAT(record->gaps(), SizeIs(0));
  EXPECT_THAT(record->damages(), SizeIs(0));
  EXPECT_TRUE(record->closed());
}

TEST_F(RemoteRecorderTest, GoesOnInAnotherFileWhenOneIsLong) {
  RemoteRecorderOptions options;
  options.max_file_bytes = 20000;
  RemoteRecorder recorder(path_, options);
  Robot robot;
  auto client = std::make_unique<LiveClient>(robot.endpoint(), recorder);
  ASSERT_TRUE(AwaitLive(recorder, true));
  for (std::uint64_t ticks = 1000; ticks <= 60000; ticks += 1000) {  // no more than the ring holds
    robot.Tick(1000);
    ASSERT_TRUE(Await(recorder, ticks));
  }
  client.reset();
  recorder.Close();
  EXPECT_EQ(recorder.error(), "");
  const auto record = Open("run.coppice");
  ASSERT_TRUE(record);
  EXPECT_GT(record->files().size(), 1u);
  EXPECT_EQ(record->last_tick(), 60000u);
  EXPECT_THAT(record->gaps(), SizeIs(0));
  EXPECT_TRUE(record->closed());
}

TEST_F(RemoteRecorderTest, RecordsAGroot2RobotFromItsTransitions) {
  RemoteRecorder recorder(path_, {});
  Robot robot;
  LiveClientOptions groot2;
  groot2.groot2_only = true;
  groot2.poll_period = groot2.board_period = std::chrono::milliseconds(5);
  auto client = std::make_unique<LiveClient>(robot.endpoint(), recorder, groot2);
  ASSERT_TRUE(AwaitLive(recorder, true));
  robot.Tick(20);
  ASSERT_TRUE(Await(recorder, 20));
  client.reset();
  recorder.Close();
  EXPECT_EQ(recorder.error(), "");
  const auto record = Open("run.coppice");
  ASSERT_TRUE(record);
  EXPECT_TRUE(record->closed());
  EXPECT_GE(record->last_tick(), 20u);
  EXPECT_EQ(record->tree().nodes.size(), robot.executor().program().nodes.size());
  EXPECT_THAT(record->damages(), SizeIs(0));
}

}  // namespace
}  // namespace coppice
