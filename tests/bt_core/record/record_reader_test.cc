#include "bt_core/record/record_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "bt_core/record/recorder.h"
#include "tests/bt_core/frames/scripted_tree.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// A record of some ticks in frames of one tick each, with a state after every fourth.
class RecordReaderTest : public ::testing::Test {
 protected:
  static constexpr int kTicks = 12;

  RecordReaderTest() {
    LeafScript script;
    SimulatedClock clock;
    Executor executor(ScriptedProgram(script), clock);
    EventStream stream(executor);
    KeptFrames frames;
    HistoryEncoder encoder({}, frames);
    EncodingListener listener(encoder);
    stream.Add(listener);
    std::mt19937 random(1);
    for (int i = 0; i < kTicks; ++i) {
      script.write = true;
      script.number = i;
      clock.Advance(std::chrono::milliseconds(100));
      executor.Tick();
      stream.Flush();
      encoder.Flush();
      if (i % 4 == 3) encoder.Keyframe();
    }
    stream.Remove(listener);
    encoder.End(HistoryEnd::Cause::kClosed, clock.Now());

    Bytes preamble;
    AppendPreamble(preamble);
    bytes_.assign(preamble.begin(), preamble.end());
    for (const Bytes& frame : frames.frames) {
      starts_.push_back(bytes_.size());
      bytes_.append(frame.begin(), frame.end());
    }
    starts_.push_back(bytes_.size());
    types_ = frames.types;
    WriteFile(folder_.Path("whole"), bytes_);
    ticks_ = ReadRecord(folder_.Path("whole")).ticks;
  }

  std::unique_ptr<RecordReader> Open(const std::string& bytes) {
    std::filesystem::remove(folder_.Path("copy"));  // a file that is cut short is written slowly
    WriteFile(folder_.Path("copy"), bytes);
    diagnostics_ = Diagnostics();
    return RecordReader::Open(folder_.Path("copy"), diagnostics_);
  }

  const TemporaryFolder folder_;
  std::string bytes_;
  std::vector<std::size_t> starts_;  // of the frames, and the end
  std::vector<FrameType> types_;
  std::vector<std::string> ticks_;
  Diagnostics diagnostics_;
};

TEST_F(RecordReaderTest, KnowsWhatThereIs) {
  const auto reader = Open(bytes_);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->tree().main_tree, "Main");
  EXPECT_THAT(reader->keyframes(), SizeIs(4));
  EXPECT_EQ(reader->first_tick(), 0u);
  EXPECT_EQ(reader->last_tick(), 12u);
  EXPECT_EQ(reader->end(), Time(std::chrono::milliseconds(1200)));
  EXPECT_THAT(reader->damages(), IsEmpty());
  EXPECT_EQ(reader->torn_bytes(), 0u);
  EXPECT_TRUE(reader->closed());
  EXPECT_THAT(ticks_, SizeIs(kTicks));
}

TEST_F(RecordReaderTest, ReadsARecordThatIsCutOffAnywhereToTheLastWholeFrame) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    const auto reader = Open(bytes_.substr(0, size));
    ASSERT_EQ(reader != nullptr, size >= starts_[2]) << size;  // tree and state
    if (!reader) {
      EXPECT_TRUE(diagnostics_.has_errors());
      continue;
    }
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), size) - 1;
    const auto whole = next - starts_.begin();
    const WholeRecord record = ReadAll(*reader);
    EXPECT_EQ(record.ticks.size(),
              std::count(types_.begin(), types_.begin() + whole, FrameType::kEvents));
    EXPECT_TRUE(std::equal(record.ticks.begin(), record.ticks.end(), ticks_.begin()));
    EXPECT_FALSE(record.closed);
    EXPECT_EQ(record.torn_bytes, size - *next);
    EXPECT_THAT(record.damages, IsEmpty());
  }
}

TEST_F(RecordReaderTest, NoticesEveryFlippedByteAndGoesOnBehindIt) {
  for (std::size_t i = starts_[2]; i < bytes_.size(); ++i) {
    std::string bytes = bytes_;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x41);
    const auto reader = Open(bytes);
    ASSERT_TRUE(reader) << i;
    const WholeRecord record = ReadAll(*reader);
    ASSERT_EQ(record.damages.size() + (record.torn_bytes > 0), 1u) << i;
    if (!record.damages.empty()) {
      EXPECT_LE(record.damages[0].offset, i);
    }
    EXPECT_GE(record.ticks.size() + 4, ticks_.size()) << "up to the next state";
    auto at = ticks_.begin();
    for (const std::string& tick : record.ticks) {
      at = std::find(at, ticks_.end(), tick);
      ASSERT_NE(at, ticks_.end()) << i;
    }
  }
}

TEST_F(RecordReaderTest, NeverCrashesOnDamagedFiles) {
  std::mt19937 random(8);
  for (int round = 0; round < 1000; ++round) {
    std::string bytes = bytes_;
    for (auto edits = 1 + random() % 8; edits > 0; --edits) {
      const std::size_t at = random() % bytes.size();
      if (random() % 3 == 0) {
        bytes.erase(at, random() % 50);
      } else {
        bytes[at] = static_cast<char>(random());
      }
    }
    if (const auto reader = Open(bytes)) ReadAll(*reader);
  }
}

TEST_F(RecordReaderTest, SaysWhatIsNotARecord) {
  EXPECT_FALSE(Open("just a text, longer than the magic bytes"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("copy: error: not a Coppice record"));
  EXPECT_FALSE(Open(""));
  EXPECT_FALSE(RecordReader::Open(folder_.Path("nothing"), diagnostics_));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("No such file"));
}

TEST_F(RecordReaderTest, SaysThatARecordIsOfAnotherVersion) {
  std::string bytes = bytes_;
  bytes[8] = 3;
  EXPECT_FALSE(Open(bytes));
  EXPECT_THAT(diagnostics_.ToString(),
              HasSubstr("a record of version 3; this program reads version 2"));
}

TEST_F(RecordReaderTest, SaysWhatIsMissingAtTheBeginning) {
  EXPECT_FALSE(Open(bytes_.substr(0, starts_[1] - 1)));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("there is no whole description of a tree"));
  EXPECT_FALSE(Open(bytes_.substr(0, starts_[2] - 1)));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("there is no whole state of the tree"));
}

TEST_F(RecordReaderTest, FollowsARecordThatGrows) {
  const std::string path = folder_.Path("copy");
  const auto reader = Open(bytes_.substr(0, starts_[2]));
  ASSERT_TRUE(reader);
  RecordCursor cursor(*reader);
  std::vector<std::string> ticks;
  for (std::size_t size = starts_[2]; size < bytes_.size(); size += 7) {
    WriteFile(path, bytes_.substr(0, size));
    reader->Refresh();
    while (cursor.Next() != RecordItem::kNone) {
      if (cursor.events().tick > ticks.size()) ticks.push_back(Describe(cursor.events()));
    }
    EXPECT_EQ(reader->last_tick(), ticks.size());
    EXPECT_EQ(cursor.state().tick(), ticks.size());
  }
  EXPECT_EQ(ticks, ticks_);
  EXPECT_FALSE(reader->Refresh());
  WriteFile(path, bytes_);
  EXPECT_TRUE(reader->Refresh());
  EXPECT_TRUE(reader->closed());
}

class RecordSeriesReaderTest : public ::testing::Test {
 protected:
  void Record(const std::string& path, int ticks) {
    SimulatedClock clock;
    Executor executor(ScriptedProgram(script_), clock);
    EventStream stream(executor);
    stream.Add(kept_);
    RecorderOptions options;
    options.max_file_bytes = 5000;
    options.flush_period = std::chrono::milliseconds(1);
    Recorder recorder(stream, path, options);
    std::mt19937 random(1);
    for (int i = 0; i < ticks; ++i) {
      TickAtRandom(random, script_, clock, executor);
      if (i % 20 == 0) stream.Flush();
    }
    EXPECT_EQ(recorder.Close().problem(), "");
    stream.Remove(kept_);
  }

  const TemporaryFolder folder_;
  LeafScript script_;
  KeptStream kept_;
};

TEST_F(RecordSeriesReaderTest, IsOpenedWithAnyOfItsFiles) {
  Record(folder_.Path("run.coppice"), 3000);
  const auto record = OpenRecord(folder_.Path("run.2.coppice"));
  EXPECT_THAT(record->files(), SizeIs(::testing::Gt(2u)));
  EXPECT_EQ(ReadAll(*record).ticks, kept_.ticks);
  EXPECT_THAT(record->trees(), SizeIs(1)) << "they repeat it";
}

TEST_F(RecordSeriesReaderTest, CanBeReadWithoutItsOldestFiles) {
  Record(folder_.Path("run.coppice"), 3000);
  std::filesystem::remove(folder_.Path("run.coppice"));
  const auto record = OpenRecord(folder_.Path("run.2.coppice"));
  const std::vector<std::string> ticks = ReadAll(*record).ticks;
  EXPECT_GT(ticks.size(), 100u);
  EXPECT_TRUE(std::equal(ticks.rbegin(), ticks.rend(), kept_.ticks.rbegin()));
}

TEST_F(RecordSeriesReaderTest, LeavesOutFilesOfOtherRuns) {
  Record(folder_.Path("other.coppice"), 3000);
  std::filesystem::rename(folder_.Path("other.2.coppice"), folder_.Path("run.2.coppice"));
  kept_.ticks.clear();
  Record(folder_.Path("run.coppice"), 3000);
  EXPECT_EQ(ReadRecord(folder_.Path("run.coppice")).ticks, kept_.ticks);
}

TEST_F(RecordSeriesReaderTest, SaysThatAFileInTheMiddleIsCutOff) {
  Record(folder_.Path("run.coppice"), 3000);
  const std::string path = folder_.Path("run.2.coppice");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) * 3 / 4 - 1);
  const WholeRecord record = ReadRecord(path);
  EXPECT_THAT(record.damages, SizeIs(1));
  EXPECT_LT(record.ticks.size(), kept_.ticks.size());
  EXPECT_EQ(record.ticks.back(), kept_.ticks.back());
}

TEST_F(RecordSeriesReaderTest, FollowsIntoNewFiles) {
  SimulatedClock clock;
  Executor executor(ScriptedProgram(script_), clock);
  EventStream stream(executor);
  RecorderOptions options;
  options.max_file_bytes = 5000;
  options.flush_period = std::chrono::milliseconds(1);
  const std::string path = folder_.Path("run.coppice");
  Recorder recorder(stream, path, options);
  std::mt19937 random(1);
  std::unique_ptr<RecordReader> reader;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while ((!reader || reader->files().size() < 3) && std::chrono::steady_clock::now() < deadline) {
    TickAtRandom(random, script_, clock, executor);
    Diagnostics ignored;
    if (!reader) reader = RecordReader::Open(path, ignored);
    if (reader) reader->Refresh();
  }
  ASSERT_TRUE(reader);
  EXPECT_EQ(recorder.Close().problem(), "");
  EXPECT_TRUE(reader->Refresh());
  EXPECT_TRUE(reader->closed());
  EXPECT_EQ(reader->last_tick(), executor.ticks());
}

}  // namespace
}  // namespace coppice
