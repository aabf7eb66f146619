#include "bt_core/record/record_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "bt_core/record/entry_coding.h"
#include "bt_core/history/frame.h"
#include "tests/bt_core/record/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr RecordWriter::Periods kNeverByItself{1h, 1h};

// A frame that begins with a time and the number of a tick.
Bytes TickFrame(Time time, std::uint64_t tick) {
  Bytes bytes;
  const std::size_t frame = OpenFrame(bytes, FrameType::kTick);
  Encoder out(bytes);
  out.At(time);
  out.Unsigned(tick);
  CloseFrame(bytes, frame);
  return bytes;
}

// "t5" for a tick at 5, "n7" for a note; "BAD" for a frame with a wrong checksum.
std::vector<std::string> Frames(const std::string& file) {
  std::vector<std::string> found;
  const Bytes bytes(file.begin(), file.end());
  for (std::size_t at = 0; at < bytes.size();) {
    const FrameHeader header = ReadFrameHeader(bytes.data() + at);
    if (!IsWhole(bytes.data() + at, header)) found.emplace_back("BAD");
    Decoder payload(bytes.data() + at + kFrameHeaderSize, bytes.data() + bytes.size());
    const bool note = header.type == static_cast<std::uint8_t>(FrameType::kNote);
    found.push_back((note ? "n" : "t") + std::to_string(payload.At().count()));
    at += kFrameHeaderSize + header.payload_size;
  }
  return found;
}

TEST(RecordWriter, WritesEverythingBeforeItEnds) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 1000, kNeverByItself);
  EXPECT_TRUE(writer.Push(TickFrame(Time(1), 1)));
  EXPECT_TRUE(writer.Push(TickFrame(Time(2), 2)));
  writer.Stop(TickFrame(Time(3), 3));
  EXPECT_THAT(Frames(ReadFile(folder.Path("a"))), ElementsAre("t1", "t2", "t3"));
  EXPECT_EQ(writer.flushed_tick(), 3u);
  EXPECT_EQ(writer.error(), "");
}

TEST(RecordWriter, PutsNotesWhereTheyBelongInTime) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 1000, kNeverByItself);
  for (const int time : {15, 25, 99}) writer.PushNote({Time(time), "k", "t"});
  for (const int time : {10, 20, 30}) writer.Push(TickFrame(Time(time), 1));
  writer.Stop({});
  EXPECT_THAT(Frames(ReadFile(folder.Path("a"))),
              ElementsAre("t10", "n15", "t20", "n25", "t30", "n99"));
}

TEST(RecordWriter, WritesByItself) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 1000, {1ms, 1ms});
  writer.Push(TickFrame(Time(1), 77));
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  while (writer.flushed_tick() != 77 && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::yield();
  }
  EXPECT_THAT(Frames(ReadFile(folder.Path("a"))), ElementsAre("t1"));
}

TEST(RecordWriter, HurriesWhenTheBufferIsHalfFull) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 100, {1s, 1h});
  const auto deadline = std::chrono::steady_clock::now() + 30s;
  std::uint64_t tick = 0;
  while (writer.flushed_tick() == 0 && std::chrono::steady_clock::now() < deadline) {
    writer.Push(TickFrame(Time(1), ++tick));
  }
  EXPECT_GT(writer.flushed_tick(), 0u);
}

TEST(RecordWriter, RefusesWhatFindsNoRoom) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 20, kNeverByItself);
  EXPECT_EQ(writer.room(), 20u);
  EXPECT_FALSE(writer.Push(Bytes(21, 0)));
}

TEST(RecordWriter, CountsNotesThatFindNoRoom) {
  const TemporaryFolder folder;
  RecordWriter writer(folder.Path("a"), {}, 1000, kNeverByItself);
  writer.PushNote({Time(0), "k", std::string(3 << 20, 'x')});
  EXPECT_EQ(writer.lost_notes(), 0u);
  writer.PushNote({Time(0), "k", std::string(3 << 20, 'x')});
  writer.PushNote({Time(0), "k", "small"});
  EXPECT_EQ(writer.lost_notes(), 1u);
  writer.ForgetLostNotes(1);
  EXPECT_EQ(writer.lost_notes(), 0u);
}

TEST(RecordWriter, ThrowsIfTheStartCannotBeWritten) {
  EXPECT_THROW(RecordWriter("/dev/full", Bytes(5, 'x'), 100, kNeverByItself), std::runtime_error);
}

TEST(RecordWriter, SaysWhatWentWrongLater) {
  RecordWriter writer("/dev/full", {}, 1000, kNeverByItself);
  writer.Push(TickFrame(Time(1), 1));
  writer.Stop({});
  EXPECT_EQ(writer.error(), "/dev/full: cannot write: No space left on device");
  EXPECT_EQ(writer.flushed_tick(), 0u);
}

}  // namespace
}  // namespace coppice
