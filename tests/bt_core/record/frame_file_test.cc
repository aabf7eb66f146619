#include "bt_core/record/frame_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kPayload = 20;
constexpr std::size_t kFrame = kFrameHeaderSize + kPayload;

// A file of notes of 20 bytes each.
class FrameFileTest : public ::testing::Test {
 protected:
  FrameFileTest() {
    std::mt19937 random(1);
    AppendPreamble(bytes_);
    for (int i = 0; i < 5; ++i) {
      const std::size_t frame = OpenFrame(bytes_, FrameType::kNote);
      for (std::size_t k = 0; k < kPayload; ++k) {
        bytes_.push_back(static_cast<std::uint8_t>(random()));
      }
      CloseFrame(bytes_, frame);
      SealFrame(bytes_.data() + frame);
    }
  }

  static std::size_t At(std::size_t frame) { return kPreambleSize + frame * kFrame; }

  FrameFile Open(const Bytes& bytes) {
    WriteFile(folder_.Path("a"), std::string(bytes.begin(), bytes.end()));
    return FrameFile(folder_.Path("a"));
  }

  const TemporaryFolder folder_;
  Bytes bytes_;
};

TEST_F(FrameFileTest, HopsFromFrameToFrame) {
  FrameFile file = Open(bytes_);
  std::uint64_t offset = kPreambleSize;
  for (std::size_t i = 0; i < 5; ++i) {
    const FrameFile::Span span = file.Hop(offset);
    EXPECT_EQ(span.offset, At(i));
    EXPECT_EQ(span.size, kFrame);
    EXPECT_EQ(span.type, static_cast<std::uint8_t>(FrameType::kNote));
    EXPECT_EQ(span.damaged, 0u);
    offset = span.offset + span.size;
  }
  EXPECT_EQ(file.Hop(offset).size, 0u);
  EXPECT_EQ(file.Hop(offset).damaged, 0u);
}

TEST_F(FrameFileTest, FindsTheFrameBehindAHeaderThatMakesNoSense) {
  Bytes bytes = bytes_;
  bytes[At(1) + 4] = 77;
  FrameFile file = Open(bytes);
  const FrameFile::Span span = file.Hop(At(1));
  EXPECT_EQ(span.offset, At(2));
  EXPECT_EQ(span.damaged, kFrame);
}

TEST_F(FrameFileTest, NoticesThatASizeWasWrongWhenWhatFollowsMakesNoSense) {
  Bytes bytes = bytes_;
  bytes[At(1)] += 5;
  FrameFile file = Open(bytes);
  const FrameFile::Span wrong = file.Hop(At(1));
  EXPECT_EQ(wrong.size, kFrame + 5);
  const FrameFile::Span span = file.Hop(wrong.offset + wrong.size);
  EXPECT_EQ(span.offset, At(2));
  EXPECT_EQ(span.damaged, kFrame);
}

TEST_F(FrameFileTest, FindsWholeFramesOnly) {
  Bytes bytes = bytes_;
  bytes[At(1) + 15] ^= 1;
  FrameFile file = Open(bytes);
  EXPECT_EQ(file.Find(At(1)).offset, At(2));
  EXPECT_EQ(file.Find(At(0) + 1).damaged, 2 * kFrame - 1);
}

TEST_F(FrameFileTest, SaysHowManyBytesAtTheEndAreNoWholeFrame) {
  for (std::size_t size = At(4) + 1; size < At(5); ++size) {
    FrameFile file = Open(Bytes(bytes_.begin(), bytes_.begin() + static_cast<long>(size)));
    const FrameFile::Span span = file.Hop(At(4));
    EXPECT_EQ(span.size, 0u);
    EXPECT_EQ(span.damaged, size - At(4));
  }
}

TEST_F(FrameFileTest, SeesWhatIsAppended) {
  FrameFile file = Open(Bytes(bytes_.begin(), bytes_.begin() + static_cast<long>(At(4) + 3)));
  EXPECT_EQ(file.Hop(At(4)).size, 0u);
  WriteFile(folder_.Path("a"), std::string(bytes_.begin(), bytes_.end()));
  EXPECT_EQ(file.Hop(At(4)).size, 0u);
  file.Refresh();
  EXPECT_EQ(file.Hop(At(4)).size, kFrame);
}

TEST_F(FrameFileTest, SaysWhatIsNoRecord) {
  EXPECT_EQ(Open({}).error(), "not a Coppice record");
  Bytes bytes = bytes_;
  bytes[8] = 1;
  EXPECT_EQ(Open(bytes).error(), "a record of version 1; this program reads version 2");
  EXPECT_THAT(FrameFile("/nowhere").error(), HasSubstr("cannot read this file: No such file"));
}

// One header after the other that promises as much as there is.
TEST_F(FrameFileTest, DoesNotSearchForEver) {
  Bytes bytes;
  AppendPreamble(bytes);
  bytes.resize(1 << 20);
  for (std::size_t at = kPreambleSize; at + 5 < bytes.size(); at += 5) {
    bytes[at + 2] = 8;  // half a megabyte
    bytes[at + 4] = static_cast<std::uint8_t>(FrameType::kEvents);
  }
  FrameFile file = Open(bytes);
  EXPECT_EQ(file.Find(kPreambleSize).size, 0u);
}

}  // namespace
}  // namespace coppice
