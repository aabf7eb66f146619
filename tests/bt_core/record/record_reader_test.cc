#include "bt_core/record/record_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "bt_core/history/frame.h"
#include "bt_core/record/recorder.h"
#include "tests/bt_core/record/recorded_tree.h"
#include "tests/bt_core/record/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

class RecordReaderTest : public ::testing::Test {
 protected:
  static constexpr int kTicks = 12;

  RecordReaderTest() {
    LeafScript script;
    SimulatedClock clock;
    Executor executor(RecordedProgram(script), clock);
    Recorder recorder(executor, folder_.Path("whole"));
    script.write = true;
    for (int i = 0; i < kTicks; ++i) {
      script.number = i;
      executor.Tick();
    }
    recorder.Close();
    bytes_ = ReadFile(folder_.Path("whole"));
    ticks_ = DescribeAll(ReadRecord(folder_.Path("whole")).ticks);
    header_size_ =
        kPreambleSize + kFrameHeaderSize + ReadFrameHeader(At(kPreambleSize)).payload_size;
  }

  const std::uint8_t* At(std::size_t offset) const {
    return reinterpret_cast<const std::uint8_t*>(bytes_.data()) + offset;
  }

  std::optional<RecordReader> Open(const std::string& bytes) {
    WriteFile(folder_.Path("copy"), bytes);
    diagnostics_ = Diagnostics();
    return RecordReader::Open(folder_.Path("copy"), diagnostics_);
  }

  const TemporaryFolder folder_;
  std::string bytes_;
  std::vector<std::string> ticks_;
  std::size_t header_size_ = 0;
  Diagnostics diagnostics_;
};

TEST_F(RecordReaderTest, ReadsAWholeRecord) {
  auto reader = Open(bytes_);
  ASSERT_TRUE(reader);
  EXPECT_EQ(reader->header().main_tree, "Main");
  const WholeRecord record = ReadAll(*reader);
  EXPECT_THAT(record.ticks, SizeIs(kTicks));
  EXPECT_THAT(record.damages, IsEmpty());
  EXPECT_TRUE(record.closed);
}

TEST_F(RecordReaderTest, ReadsARecordThatIsCutOffAnywhereToTheLastWholeTick) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    auto reader = Open(bytes_.substr(0, size));
    ASSERT_EQ(reader.has_value(), size >= header_size_) << size;
    if (!reader) {
      EXPECT_TRUE(diagnostics_.has_errors());
      continue;
    }
    const WholeRecord record = ReadAll(*reader);
    const auto ticks = DescribeAll(record.ticks);
    EXPECT_TRUE(std::equal(ticks.begin(), ticks.end(), ticks_.begin()));
    EXPECT_FALSE(record.closed);
    // Whatever is not of a whole frame is reported; nothing else is.
    std::size_t whole = header_size_;
    std::size_t frames = 0;
    while (whole < size) {
      const std::size_t next =
          whole + kFrameHeaderSize +
          (whole + kFrameHeaderSize <= size ? ReadFrameHeader(At(whole)).payload_size : 0);
      if (whole + kFrameHeaderSize > size || next > size) break;
      whole = next;
      ++frames;
    }
    EXPECT_EQ(ticks.size(), frames);
    EXPECT_THAT(record.damages, SizeIs(whole < size ? 1 : 0));
    if (whole < size) {
      EXPECT_EQ(record.damages[0].offset, whole);
      EXPECT_EQ(record.damages[0].what,
                "the last " + std::to_string(size - whole) + " bytes are not a whole frame");
    }
  }
}

TEST_F(RecordReaderTest, NoticesEveryFlippedByteAndGoesOnBehindIt) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    std::string bytes = bytes_;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x41);
    auto reader = Open(bytes);
    ASSERT_EQ(reader.has_value(), i >= header_size_) << i;
    if (!reader) continue;
    const WholeRecord record = ReadAll(*reader);
    ASSERT_THAT(record.damages, SizeIs(1)) << i;
    EXPECT_LE(record.damages[0].offset, i);
    EXPECT_GE(record.ticks.size() + 1, ticks_.size());
    for (const std::string& tick : DescribeAll(record.ticks)) {
      EXPECT_THAT(ticks_, ::testing::Contains(tick));
    }
  }
}

TEST_F(RecordReaderTest, SaysWhatIsNotARecord) {
  EXPECT_FALSE(Open("just a text, longer than the magic bytes"));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("copy: error: not a Coppice record"));
  EXPECT_FALSE(Open(""));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("not a Coppice record"));
}

TEST_F(RecordReaderTest, SaysThatARecordIsOfANewerVersion) {
  std::string bytes = bytes_;
  bytes[8] = 2;
  EXPECT_FALSE(Open(bytes));
  EXPECT_THAT(diagnostics_.ToString(),
              HasSubstr("a record of version 2; this program reads version 1"));
}

TEST_F(RecordReaderTest, SaysThatTheHeaderIsCutOff) {
  EXPECT_FALSE(Open(bytes_.substr(0, header_size_ - 1)));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("header of this record, at byte 12, is cut off"));
}

TEST_F(RecordReaderTest, LeavesOutAFrameThatDoesNotMakeSense) {
  Bytes frame;
  OpenFrame(frame, FrameType::kTick);
  Encoder(frame).Text("nonsense");
  CloseFrame(frame, 0);
  SealFrame(frame.data());
  auto reader = Open(bytes_.substr(0, header_size_) + std::string(frame.begin(), frame.end()) +
                     bytes_.substr(header_size_));
  ASSERT_TRUE(reader);
  const WholeRecord record = ReadAll(*reader);
  EXPECT_EQ(DescribeAll(record.ticks), ticks_);
  ASSERT_THAT(record.damages, SizeIs(1));
  EXPECT_EQ(record.damages[0].offset, header_size_);
}

TEST_F(RecordReaderTest, SaysWhyAFileCannotBeRead) {
  EXPECT_FALSE(RecordReader::Open(folder_.Path("nothing"), diagnostics_));
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("No such file"));
}

}  // namespace
}  // namespace coppice
