#include "bt_core/record/recorder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <random>
#include <thread>

#include "tests/bt_core/record/counting_new.h"
#include "tests/bt_core/record/recorded_tree.h"
#include "tests/bt_core/record/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest() { executor_.AddSink(&keeper_); }

  std::string path() const { return folder_.Path("run.coppice"); }

  void TickAtRandom(std::mt19937& random) {
    clock_.Advance(Duration(random() % 1000000));
    script_.write = random() % 3 == 0;
    script_.number = static_cast<int>(random());
    script_.ratio = static_cast<double>(random()) / 7;
    script_.text.assign(random() % 40, static_cast<char>(random()));
    script_.message = random() % 4 ? "" : "message " + std::to_string(random());
    script_.status = [&random] { return static_cast<Status>(1 + random() % 4); };
    if (random() % 20 == 0) executor_.Halt();
    executor_.Tick();
  }

  const TemporaryFolder folder_;
  LeafScript script_;
  SimulatedClock clock_;
  Keeper keeper_;  // gets the last halt from the executor's destructor
  Executor executor_{RecordedProgram(script_), clock_};
};

TEST_F(RecorderTest, RecordsEveryTickInWhichSomethingHappens) {
  Recorder recorder(executor_, path());
  executor_.Tick();
  executor_.Tick();  // nothing new
  script_.message = "because";
  executor_.Tick();
  EXPECT_EQ(recorder.Close(), "");
  const WholeRecord record = ReadRecord(path());
  EXPECT_THAT(record.ticks, SizeIs(2));
  EXPECT_EQ(DescribeAll(record.ticks), DescribeAll(keeper_.ticks));
  EXPECT_TRUE(record.closed);
}

TEST_F(RecorderTest, RecordsWhateverATreeDoes) {
  std::mt19937 random(11);
  Recorder recorder(executor_, path());
  for (int i = 0; i < 2000; ++i) TickAtRandom(random);
  EXPECT_EQ(recorder.Close(), "");
  const WholeRecord record = ReadRecord(path());
  EXPECT_GT(record.ticks.size(), 1000u);
  EXPECT_EQ(DescribeAll(record.ticks), DescribeAll(keeper_.ticks));
  EXPECT_THAT(record.damages, SizeIs(0));
}

TEST_F(RecorderTest, KeepsNotesFromAnyThreadInOrderOfTime) {
  Recorder recorder(executor_, path());
  std::thread other([&] { recorder.Note(Time(10), "fault", "laser unplugged"); });
  other.join();
  clock_.Advance(Duration(20));
  executor_.Tick();
  recorder.Note(Time(30), "fault", "laser back");
  recorder.Close();
  const WholeRecord record = ReadRecord(path());
  ASSERT_THAT(record.notes, SizeIs(2));
  EXPECT_EQ(record.notes[0].time, Time(10));
  EXPECT_EQ(record.notes[0].kind, "fault");
  EXPECT_EQ(record.notes[1].text, "laser back");
}

TEST_F(RecorderTest, DoesNotAllocateInASteadyTick) {
  Recorder recorder(executor_, path());
  executor_.RemoveSink(&keeper_);
  script_.write = true;
  script_.text = "a text that does not fit into the string object itself";
  const auto tick = [&](int i) {
    script_.number = i;
    script_.ratio = i / 3.0;
    script_.status = [i] { return i % 2 ? Status::kSuccess : Status::kFailure; };
    executor_.Tick();
  };
  for (int i = 0; i < 100; ++i) tick(i);
  std::uint64_t allocations = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t before = Allocations();
    tick(i);
    allocations += Allocations() - before;
  }
  EXPECT_EQ(allocations, 0u);
  EXPECT_EQ(recorder.Close(), "");
}

/// A file system that stands still until Drain is called: a pipe that nobody reads.
class SlowDisk {
 public:
  explicit SlowDisk(std::string path) : path_(std::move(path)) {
    mkfifo(path_.c_str(), 0600);
    pipe_ = open(path_.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    fcntl(pipe_, F_SETPIPE_SZ, 4096);
  }
  ~SlowDisk() {
    if (reader_.joinable()) reader_.join();
    close(pipe_);
  }
  void Drain() {
    fcntl(pipe_, F_SETFL, 0);
    reader_ = std::thread([this] {
      char buffer[4096];
      for (ssize_t n = 0; (n = read(pipe_, buffer, sizeof(buffer))) > 0;) {
        content_.append(buffer, static_cast<std::size_t>(n));
      }
    });
  }
  /// Everything, once the writer has closed.
  const std::string& Content() {
    reader_.join();
    return content_;
  }

 private:
  std::string path_;
  int pipe_;
  std::thread reader_;
  std::string content_;
};

TEST_F(RecorderTest, LeavesOutTicksThatTheDiskCannotTakeAndSaysSo) {
  SlowDisk disk(path());
  RecorderOptions options;
  options.buffer_bytes = 8000;
  options.flush_period = 1ms;
  auto recorder = std::make_unique<Recorder>(executor_, path(), options);
  std::mt19937 random(2);
  while (recorder->lost_ticks() < 100) TickAtRandom(random);  // goes on although the disk does not
  const std::uint64_t lost = recorder->lost_ticks();
  disk.Drain();
  const std::uint64_t now = executor_.ticks();
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (recorder->flushed_tick() <= now && std::chrono::steady_clock::now() < deadline) {
    TickAtRandom(random);
  }
  EXPECT_THAT(recorder->Close(), HasSubstr("ticks are missing: the disk was too slow"));
  const std::uint64_t all_lost = recorder->lost_ticks();
  recorder.reset();
  WriteFile(folder_.Path("copy"), disk.Content());

  const WholeRecord record = ReadRecord(folder_.Path("copy"));
  EXPECT_THAT(record.damages, SizeIs(0));
  std::uint64_t counted = 0;
  for (const RecordedGap& gap : record.gaps) counted += gap.lost_ticks;
  EXPECT_GE(all_lost, lost);
  EXPECT_EQ(counted, all_lost);
  EXPECT_EQ(record.ticks.size() + all_lost, keeper_.ticks.size());
  const std::vector<std::string> kept = DescribeAll(keeper_.ticks);
  for (const std::string& tick : DescribeAll(record.ticks)) {
    EXPECT_EQ(std::count(kept.begin(), kept.end(), tick), 1) << tick;
  }
}

// Statuses after all changes, with the state of the gaps taken over.
TEST_F(RecorderTest, GivesTheStateOfTheTreeAfterAGap) {
  SlowDisk disk(path());
  RecorderOptions options;
  options.buffer_bytes = 8000;
  options.flush_period = 1ms;
  auto recorder = std::make_unique<Recorder>(executor_, path(), options);
  std::mt19937 random(3);
  while (recorder->lost_ticks() < 100) TickAtRandom(random);
  disk.Drain();
  recorder->Close();
  recorder.reset();
  WriteFile(folder_.Path("copy"), disk.Content());
  const WholeRecord record = ReadRecord(folder_.Path("copy"));
  ASSERT_FALSE(record.gaps.empty());
  EXPECT_EQ(record.gaps.back().state.statuses, executor_.statuses());
  for (SlotIndex slot = 0; slot < executor_.blackboard().size(); ++slot) {
    EXPECT_EQ(record.gaps.back().state.values[slot].value_or(""),
              executor_.blackboard()[slot].value.Print());
  }
}

TEST_F(RecorderTest, ThrowsRatherThanOverwriting) {
  WriteFile(path(), "precious");
  EXPECT_THROW(Recorder(executor_, path()), std::runtime_error);
  EXPECT_EQ(ReadFile(path()), "precious");
  executor_.Tick();  // nothing is left behind in the executor
}

TEST_F(RecorderTest, ClosesOnceAndStopsListening) {
  Recorder recorder(executor_, path());
  recorder.Close();
  const std::string content = ReadFile(path());
  executor_.Tick();
  EXPECT_EQ(recorder.Close(), "");
  EXPECT_EQ(ReadFile(path()), content);
}

}  // namespace
}  // namespace coppice
