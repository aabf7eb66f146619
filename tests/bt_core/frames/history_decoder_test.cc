#include "bt_core/frames/history_decoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/frames/kept_history.h"
#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

using ::testing::SizeIs;

class HistoryDecoderTest : public ::testing::Test {
 protected:
  HistoryDecoderTest() {
    LeafScript script;
    SimulatedClock clock;
    Executor executor(ScriptedProgram(script), clock);
    EventStream stream(executor);
    HistoryEncoder encoder({}, frames_);
    EncodingListener listener(encoder);
    stream.Add(listener);
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
      TickAtRandom(random, script, clock, executor);
      stream.Flush();
      if (i % 5 == 0) encoder.Flush();
      if (i % 20 == 0) encoder.Keyframe();
    }
    stream.Remove(listener);
    encoder.Note({Time(Duration(1)), "a", "b"});
    encoder.End(HistoryEnd::Cause::kClosed, Time(Duration(1)));
  }

  KeptFrames frames_;
};

TEST_F(HistoryDecoderTest, RefusesFramesThatAreDamaged) {
  for (std::size_t f = 0; f < frames_.frames.size(); ++f) {
    HistoryDecoder decoder;
    KeptHistory history;
    for (std::size_t i = 0; i < f; ++i) {
      ASSERT_EQ(
          decoder.Decode(frames_.frames[i].data(), frames_.frames[i].size(), history).problem(),
          "");
    }
    Bytes bytes = frames_.frames[f];
    bytes[bytes.size() / 2] ^= 1;
    EXPECT_NE(decoder.Decode(bytes.data(), bytes.size(), history).problem(), "");
    EXPECT_NE(decoder.Decode(bytes.data(), bytes.size() - 1, history).problem(), "");
    EXPECT_NE(decoder.Decode(bytes.data(), 3, history).problem(), "");
    EXPECT_FALSE(decoder.follows());
  }
}

TEST_F(HistoryDecoderTest, NeedsATreeForAStateAndAStateForEvents) {
  for (std::size_t f = 0; f < frames_.frames.size(); ++f) {
    HistoryDecoder decoder;
    KeptHistory history;
    const std::string problem =
        decoder.Decode(frames_.frames[f].data(), frames_.frames[f].size(), history).problem();
    if (frames_.types[f] == FrameType::kState) {
      EXPECT_EQ(problem, "a state without a tree");
    } else if (frames_.types[f] == FrameType::kEvents) {
      EXPECT_EQ(problem, "events without the state before them");
    } else {
      EXPECT_EQ(problem, "");
    }
  }
}

TEST_F(HistoryDecoderTest, GoesOnAtAStateAfterSomethingIsMissing) {
  KeptHistory all;
  EXPECT_EQ(frames_.DecodeAll(all).problem(), "");
  HistoryDecoder decoder;
  KeptHistory history;
  int refused = 0;
  for (std::size_t f = 0; f < frames_.frames.size(); ++f) {
    if (f == 3) {
      decoder.Forget();
      continue;
    }
    refused += !decoder.Decode(frames_.frames[f].data(), frames_.frames[f].size(), history);
  }
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(decoder.follows());
  EXPECT_EQ(history.lines.back(), all.lines.back());
}

// Sealed anew, so that they pass the checksum.
TEST_F(HistoryDecoderTest, NeverCrashesOnFramesOfNonsense) {
  std::mt19937 random(5);
  int taken = 0;
  for (int round = 0; round < 3000; ++round) {
    HistoryDecoder decoder;
    KeptHistory history;
    for (Bytes frame : frames_.frames) {
      if (random() % 4 == 0) {
        for (auto edits = 1 + random() % 4; edits > 0; --edits) {
          const std::size_t at = kFrameHeaderSize + random() % (frame.size() - kFrameHeaderSize);
          frame[at] = static_cast<std::uint8_t>(random());
        }
        if (random() % 4 == 0) frame[4] = static_cast<std::uint8_t>(random() % 8);
        SealFrame(frame.data());
      }
      taken += decoder.Decode(frame.data(), frame.size(), history).ok();
    }
  }
  EXPECT_GT(taken, 10000);
}

TEST(HistoryDecoder, RefusesAFrameOfMoreTicksThanAreWritten) {
  LeafScript script;
  SimulatedClock clock;
  Executor executor(ScriptedProgram(script), clock);
  EventStream stream(executor);
  KeptFrames frames;
  HistoryOptions options;
  options.frame_bytes = kMaxRawSize;
  options.keyframe_bytes = kMaxRawSize;
  HistoryEncoder encoder(options, frames);
  EncodingListener listener(encoder);
  stream.Add(listener);
  stream.Flush();
  stream.Remove(listener);
  TickEvents tick;
  tick.is_whole = true;
  tick.result = Status::kRunning;
  for (std::size_t i = 0; i <= kMaxTicksInFrame; ++i) {
    ++tick.tick;
    encoder.Add(tick);
  }
  encoder.Flush();
  HistoryDecoder decoder;
  KeptHistory history;
  std::string problem;
  std::size_t packed = 0;
  for (const Bytes& frame : frames.frames) {
    problem += decoder.Decode(frame.data(), frame.size(), history).problem();
    packed += frame.size();
  }
  EXPECT_EQ(problem, "more ticks than a frame can have");
  EXPECT_LT(packed, 10000u);
}

}  // namespace
}  // namespace coppice
