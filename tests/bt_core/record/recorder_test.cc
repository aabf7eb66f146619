#include "bt_core/record/recorder.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <random>
#include <thread>

#include "bt_core/record/record_file.h"
#include "tests/bt_core/frames/scripted_tree.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/full_disk.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest() { stream_.Add(kept_); }
  ~RecorderTest() override { stream_.Remove(kept_); }

  std::string path() const { return folder_.Path("run.coppice"); }
  void Tick() { TickAtRandom(random_, script_, clock_, executor_); }
  std::string TroubleAfterDeletion(Duration deletion_told);

  const TemporaryFolder folder_;
  std::mt19937 random_{11};
  LeafScript script_;
  SimulatedClock clock_;
  Executor executor_{ScriptedProgram(script_), clock_};
  EventStream stream_{executor_};
  KeptStream kept_;
};

TEST_F(RecorderTest, RecordsWhateverATreeDoes) {
  Recorder recorder(stream_, path());
  for (int i = 0; i < 2000; ++i) Tick();
  EXPECT_EQ(recorder.Close().problem(), "");
  const WholeRecord record = ReadRecord(path());
  EXPECT_GT(record.ticks.size(), 2000u) << "ticks and halts";
  EXPECT_EQ(record.ticks, kept_.ticks);
  EXPECT_THAT(record.damages, SizeIs(0));
  EXPECT_TRUE(record.closed);
}

TEST_F(RecorderTest, BeginsWithTheTreeAsItStands) {
  for (int i = 0; i < 10; ++i) Tick();
  RecorderOptions options;
  options.metadata = {{"robot", "sobi-1"}};
  options.clock = "ros";
  Recorder recorder(stream_, path(), options);
  static_cast<void>(recorder.Close());
  const auto record = OpenRecord(path());
  EXPECT_EQ(record->tree().info.metadata, options.metadata);
  EXPECT_EQ(record->tree().info.clock, "ros");
  EXPECT_EQ(record->tree().info.start, clock_.Now());
  EXPECT_NE(record->tree().info.run, RunId());
  EXPECT_EQ(record->first_tick(), 10u);
  EXPECT_EQ(RecordCursor(*record).state().statuses(), executor_.statuses());
}

TEST_F(RecorderTest, KeepsNotesFromAnyThread) {
  Recorder recorder(stream_, path());
  std::thread other([&] { recorder.Note(Time(Duration(10)), "fault", "laser unplugged"); });
  other.join();
  Tick();
  recorder.Note(Time(Duration(30)), "fault", "laser back");
  static_cast<void>(recorder.Close());
  const WholeRecord record = ReadRecord(path());
  ASSERT_THAT(record.notes, SizeIs(2));
  EXPECT_EQ(record.notes[0].time, Time(Duration(10)));
  EXPECT_EQ(record.notes[0].kind, "fault");
  EXPECT_EQ(record.notes[1].text, "laser back");
  EXPECT_THAT(OpenRecord(path())->notes(), SizeIs(2));
}

TEST_F(RecorderTest, GoesOnWhenTheTreeIsSwapped) {
  Recorder recorder(stream_, path());
  for (int i = 0; i < 10; ++i) Tick();
  executor_.Reload(OtherScriptedProgram(script_));
  for (int i = 0; i < 10; ++i) Tick();
  EXPECT_EQ(recorder.Close().problem(), "");
  EXPECT_EQ(ReadRecord(path()).ticks, kept_.ticks);
  const auto record = OpenRecord(path());
  ASSERT_THAT(record->trees(), SizeIs(2));
  RecordCursor cursor(*record);
  cursor.SeekLast();
  EXPECT_EQ(cursor.tree().nodes[2].path, "new");
  EXPECT_EQ(cursor.state().statuses(), executor_.statuses());
}

TEST_F(RecorderTest, GoesOnInAnotherFileWhenOneIsLongEnough) {
  RecorderOptions options;
  options.max_file_bytes = 20000;
  options.flush_period = 1ms;
  Recorder recorder(stream_, path(), options);
  for (int i = 0; i < 5000; ++i) Tick();
  EXPECT_EQ(recorder.Close().problem(), "");
  const auto record = OpenRecord(path());
  EXPECT_GT(record->files().size(), 2u);
  EXPECT_EQ(ReadAll(*record).ticks, kept_.ticks);
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
  auto recorder = std::make_unique<Recorder>(stream_, path(), options);
  while (recorder->lost_ticks() < 100) {  // goes on although the disk does not
    Tick();
    stream_.Flush();
  }
  const std::uint64_t lost = recorder->lost_ticks();
  for (int i = 0; i < 3; ++i) recorder->Note(Time{}, "note", "finds no room");
  disk.Drain();
  const std::uint64_t now = executor_.ticks();
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (recorder->flushed_tick() <= now && std::chrono::steady_clock::now() < deadline) Tick();
  EXPECT_THAT(recorder->Close().problem(),
              HasSubstr("ticks are missing: disk or computer was too slow"));
  const std::uint64_t all_lost = recorder->lost_ticks();
  recorder.reset();
  WriteFile(folder_.Path("copy"), disk.Content());

  const WholeRecord record = ReadRecord(folder_.Path("copy"));
  EXPECT_THAT(record.damages, SizeIs(0));
  std::uint64_t counted = 0;
  std::uint64_t notes = 0;
  for (const HistoryGap& gap : record.gaps) {
    counted += gap.lost_ticks;
    notes += gap.lost_notes;
  }
  EXPECT_EQ(notes, 3u);
  EXPECT_GE(all_lost, lost);
  EXPECT_EQ(counted, all_lost);
  EXPECT_EQ(record.ticks.size() + all_lost, kept_.ticks.size());
  auto kept = kept_.ticks.begin();  // what is there is right and in order
  for (const std::string& tick : record.ticks) {
    kept = std::find(kept, kept_.ticks.end(), tick);
    ASSERT_NE(kept, kept_.ticks.end()) << tick;
  }
}

TEST_F(RecorderTest, GivesTheStateOfTheTreeAfterAGap) {
  SlowDisk disk(path());
  RecorderOptions options;
  options.buffer_bytes = 8000;
  options.flush_period = 1ms;
  auto recorder = std::make_unique<Recorder>(stream_, path(), options);
  while (recorder->lost_ticks() < 100) {
    Tick();
    stream_.Flush();
  }
  disk.Drain();
  static_cast<void>(recorder->Close());
  recorder.reset();
  WriteFile(folder_.Path("copy"), disk.Content());
  const auto record = OpenRecord(folder_.Path("copy"));
  ASSERT_FALSE(record->gaps().empty());
  RecordCursor cursor(*record);
  cursor.SeekLast();
  EXPECT_EQ(cursor.state().statuses(), executor_.statuses());
  for (SlotIndex slot{0}; slot < executor_.blackboard().size(); ++slot) {
    EXPECT_EQ(PrintValueBytes(cursor.state().values()[slot]),
              executor_.blackboard()[slot].value.Print());
  }
}

TEST_F(RecorderTest, GoesOnWhenThereIsRoomOnTheDiskAgain) {
  RecorderOptions options;
  options.buffer_bytes = 8000;
  options.flush_period = 1ms;
  Recorder recorder(stream_, path(), options);
  {
    const FullDisk disk(20000);
    while (recorder.lost_ticks() < 100) {
      Tick();
      stream_.Flush();
    }
    EXPECT_THAT(recorder.trouble(), HasSubstr("run.coppice: cannot write: File too large"));
  }
  const std::uint64_t now = executor_.ticks();
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (recorder.flushed_tick() <= now && std::chrono::steady_clock::now() < deadline) Tick();
  EXPECT_EQ(recorder.trouble(), "");
  EXPECT_THAT(recorder.Close().problem(), HasSubstr("File too large"));
  const WholeRecord record = ReadRecord(path());
  EXPECT_THAT(record.damages, SizeIs(0));
  EXPECT_TRUE(record.closed);
  std::uint64_t counted = 0;
  for (const HistoryGap& gap : record.gaps) counted += gap.lost_ticks;
  EXPECT_EQ(counted, recorder.lost_ticks());
  EXPECT_EQ(record.ticks.size() + counted, kept_.ticks.size());
}

TEST_F(RecorderTest, BeginsAnotherFileWhenItsFolderIsDeleted) {
  const std::string folder = folder_.Path("records");
  std::filesystem::create_directory(folder);
  RecorderOptions options;
  options.flush_period = 1ms;
  options.sync_period = 0ms;
  Recorder recorder(stream_, folder + "/run.coppice", options);
  Tick();
  std::filesystem::remove_all(folder);
  const std::string next = folder + "/run.2.coppice";
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (!std::filesystem::exists(next) && std::chrono::steady_clock::now() < deadline) Tick();
  Tick();
  EXPECT_THAT(recorder.Close().problem(), HasSubstr("deleted this record"));
  const WholeRecord record = ReadRecord(next);
  EXPECT_TRUE(record.closed);
  ASSERT_FALSE(record.ticks.empty());
  EXPECT_EQ(record.ticks.back(), kept_.ticks.back());
}

// Records, deletes the file, and goes on until the record does so, too; then asks for troubles.
std::string RecorderTest::TroubleAfterDeletion(Duration deletion_told) {
  RecorderOptions options;
  options.flush_period = 1ms;
  options.sync_period = 0ms;
  options.deletion_told = deletion_told;
  Recorder recorder(stream_, path(), options);
  Tick();
  std::filesystem::remove(path());
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  const auto tick_until = [&](const std::function<bool()>& holds) {
    while (!holds() && std::chrono::steady_clock::now() < deadline) Tick();
  };
  tick_until([&] { return std::filesystem::exists(folder_.Path("run.2.coppice")); });
  const std::uint64_t now = executor_.ticks();
  tick_until([&] { return recorder.flushed_tick() > now; });
  return recorder.trouble();
}

// Who asks once a second must hear of it, though it is over within milliseconds.
TEST_F(RecorderTest, TellsForAWhileThatItsFileWasDeleted) {
  EXPECT_THAT(TroubleAfterDeletion(1h), HasSubstr("run.coppice: somebody has deleted this record"));
}

TEST_F(RecorderTest, TellsNotForEverThatItsFileWasDeleted) {
  EXPECT_EQ(TroubleAfterDeletion(0s), "");
}

// What is written into a file without a name is lost, whatever the kernel says.
TEST_F(RecorderTest, SaysWhyItCannotGoOnInAnotherFile) {
  const std::string folder = folder_.Path("records");
  std::filesystem::create_directory(folder);
  RecorderOptions options;
  options.flush_period = 1ms;
  options.sync_period = 0ms;
  Recorder recorder(stream_, folder + "/run.coppice", options);
  Tick();
  std::filesystem::remove_all(folder);
  WriteFile(folder, "no folder");
  const auto says_why = [&] {
    return recorder.trouble().find("run.2.coppice: cannot make this record") != std::string::npos;
  };
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (!says_why() && std::chrono::steady_clock::now() < deadline) Tick();
  const std::uint64_t now = executor_.ticks();
  while (recorder.flushed_tick() <= now && std::chrono::steady_clock::now() < deadline) Tick();
  EXPECT_THAT(recorder.trouble(), HasSubstr("cannot make this record"));
}

TEST_F(RecorderTest, ThrowsRatherThanOverwriting) {
  WriteFile(path(), "precious");
  EXPECT_THROW(Recorder(stream_, path()), std::runtime_error);
  EXPECT_EQ(ReadFile(path()), "precious");
  Tick();  // nothing is left behind in the stream
}

// Two programs that are started at the same moment: neither has written anything yet.
TEST_F(RecorderTest, ThrowsWhereAnotherIsAboutToRecord) {
  const RecordFile other(path());
  EXPECT_THROW(Recorder(stream_, path()), std::runtime_error);
  EXPECT_EQ(ReadFile(path()), "");
}

TEST_F(RecorderTest, ClosesOnceAndStopsListening) {
  Recorder recorder(stream_, path());
  static_cast<void>(recorder.Close());
  const std::string content = ReadFile(path());
  Tick();
  EXPECT_EQ(recorder.Close().problem(), "");
  EXPECT_EQ(ReadFile(path()), content);
}

}  // namespace
}  // namespace coppice
