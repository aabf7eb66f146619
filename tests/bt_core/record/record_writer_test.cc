#include "bt_core/record/record_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>

#include "bt_core/record/recorder.h"
#include "tests/bt_core/frames/scripted_tree.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class RecordWriterTest : public ::testing::Test {
 protected:
  RecordWriterTest() {
    options_.flush_period = 1h;
    options_.sync_period = 1h;
    LeafScript script;
    state_.cause = StreamState::Cause::kBegin;
    state_.program = ScriptedProgram(script);
    state_.statuses.resize(state_.program->nodes.size());
    state_.values.resize(state_.program->layout.slots.size());
    words_.Status(NodeIndex{1}, Status::kRunning);
    words_.Status(kRootNode, Status::kRunning);
  }

  std::string path() const { return folder_.Path("run.coppice"); }
  TickEvents Tick(std::uint64_t number) const {
    return {number, Time(number * 100ms), 10us, Status::kRunning, true, words_.words()};
  }
  template <class Done>
  static void WaitUntil(Done done) {
    const auto deadline = std::chrono::steady_clock::now() + 30s;
    while (!done() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    EXPECT_TRUE(done());
  }

  const TemporaryFolder folder_;
  RecorderOptions options_;
  StreamState state_;
  EventWriter words_;
};

TEST_F(RecordWriterTest, WritesEverythingBeforeItEnds) {
  RecordWriter writer(path(), options_, {});
  writer.Add(state_);
  for (std::uint64_t i = 1; i <= 10; ++i) writer.Add(Tick(i));
  writer.Add(HistoryNote{Time(5s), "kind", "text"});
  writer.Stop(Time(6s));
  EXPECT_EQ(writer.error(), "");
  EXPECT_EQ(writer.flushed_tick(), 10u);
  const WholeRecord record = ReadRecord(path());
  EXPECT_THAT(record.ticks, SizeIs(10));
  EXPECT_THAT(record.notes, SizeIs(1));
  EXPECT_TRUE(record.closed);
}

TEST_F(RecordWriterTest, WritesByItself) {
  options_.flush_period = 1ms;
  RecordWriter writer(path(), options_, {});
  writer.Add(state_);
  writer.Add(Tick(77));
  WaitUntil([&] { return writer.flushed_tick() == 77; });
  EXPECT_THAT(ReadRecord(path()).ticks, SizeIs(1));
}

TEST_F(RecordWriterTest, HurriesWhenTheBufferIsHalfFull) {
  options_.buffer_bytes = 4000;
  HistoryOptions history;
  history.frame_bytes = 10;
  RecordWriter writer(path(), options_, history);
  writer.Add(state_);
  std::uint64_t tick = 0;
  WaitUntil([&] {
    writer.Add(Tick(++tick));
    return writer.flushed_tick() > 0;
  });
}

TEST_F(RecordWriterTest, GoesOnInAnotherFileWhenOneIsLongEnough) {
  options_.max_file_bytes = 1;
  HistoryOptions history;
  history.info.run = MakeRunId();
  history.frame_bytes = 10;
  RecordWriter writer(path(), options_, history);
  writer.Add(state_);
  for (std::uint64_t i = 1; i <= 2000; ++i) writer.Add(Tick(i));
  writer.Stop(Time(6s));
  const auto record = OpenRecord(path());
  EXPECT_THAT(record->files(), SizeIs(::testing::Gt(3u)));
  const WholeRecord all = ReadAll(*record);
  EXPECT_THAT(all.ticks, SizeIs(2000));
  EXPECT_THAT(all.damages, SizeIs(0));
  EXPECT_TRUE(all.closed);
}

TEST_F(RecordWriterTest, ThrowsIfTheFileCannotBeWritten) {
  const FullDisk disk(0);
  EXPECT_THROW(RecordWriter(path(), options_, {}), std::runtime_error);
}

}  // namespace
}  // namespace coppice
