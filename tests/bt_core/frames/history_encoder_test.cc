#include "bt_core/frames/history_encoder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/frames/kept_history.h"
#include "tests/bt_core/frames/scripted_tree.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

class HistoryEncoderTest : public ::testing::Test {
 protected:
  void Listen() {
    stream_.Add(kept_);
    stream_.Add(listener_);
  }
  void Tick() {
    TickAtRandom(random_, script_, clock_, executor_);
    stream_.Flush();
  }
  // What the frames bring back must be what the stream handed out.
  void ExpectSame() {
    encoder_.Flush();
    KeptHistory history;
    EXPECT_EQ(frames_.DecodeAll(history).problem(), "");
    EXPECT_EQ(history.lines, kept_.lines);
  }
  ~HistoryEncoderTest() override {
    stream_.Remove(kept_);
    stream_.Remove(listener_);
  }

  std::mt19937 random_{7};
  LeafScript script_;
  SimulatedClock clock_;
  Executor executor_{ScriptedProgram(script_), clock_};
  EventStream stream_{executor_};
  KeptFrames frames_;
  HistoryEncoder encoder_{{}, frames_};
  KeptStream kept_;
  EncodingListener listener_{encoder_};
};

TEST_F(HistoryEncoderTest, BringsBackWhateverATreeDoes) {
  Listen();
  for (int i = 0; i < 3000; ++i) TickAtRandom(random_, script_, clock_, executor_);
  stream_.Flush();
  EXPECT_THAT(kept_.lines, SizeIs(::testing::Gt(3000u)));
  ExpectSame();
}

TEST_F(HistoryEncoderTest, BringsBackTicksThatRepeatThemselvesAndTheStateBehindThem) {
  Listen();
  for (int i = 0; i < 300; ++i) {
    if (i % 3 == 0) Tick();
    const auto status = static_cast<Status>(1 + random_() % 4);
    script_.status = [status] { return status; };
    for (auto times = random_() % 5; times > 0; --times) {
      clock_.Advance(std::chrono::milliseconds(10));
      executor_.Tick();
    }
    stream_.Flush();
    ASSERT_EQ(encoder_.follower()->statuses(), executor_.statuses()) << i;
    ASSERT_EQ(encoder_.follower()->tick(), executor_.ticks());
  }
  ExpectSame();
}

TEST_F(HistoryEncoderTest, BeginsWithTreeAndState) {
  Tick();
  Tick();
  Listen();
  stream_.Flush();
  ExpectSame();
  EXPECT_THAT(frames_.types, ElementsAre(FrameType::kTree, FrameType::kState));
}

TEST_F(HistoryEncoderTest, KeepsEventsUntilTheyAreFlushed) {
  Listen();
  for (int i = 0; i < 20; ++i) Tick();
  EXPECT_EQ(frames_.Count(FrameType::kEvents), 0u);
  EXPECT_GT(encoder_.unflushed(), 0u);
  encoder_.Flush();
  EXPECT_EQ(encoder_.unflushed(), 0u);
  encoder_.Flush();
  EXPECT_EQ(frames_.Count(FrameType::kEvents), 1u);
}

TEST_F(HistoryEncoderTest, DescribesTheTreeAgainAfterASwap) {
  Listen();
  Tick();
  executor_.Reload(OtherScriptedProgram(script_));
  Tick();
  ExpectSame();
  KeptHistory history;
  EXPECT_TRUE(frames_.DecodeAll(history));
  ASSERT_THAT(history.trees, SizeIs(2));
  EXPECT_EQ(history.trees[1].nodes[2].path, "new");
  EXPECT_EQ(history.trees[1].info.run, history.trees[0].info.run);
  EXPECT_EQ(history.states[1].cause, HistoryState::Cause::kJump);
}

TEST_F(HistoryEncoderTest, SaysThatTheTreeWasGivenAnotherState) {
  Listen();
  Tick();
  const TreeState state = executor_.Save();
  Tick();
  executor_.Restore(state);
  Tick();
  ExpectSame();
  EXPECT_EQ(frames_.Count(FrameType::kTree), 1u);
  EXPECT_EQ(frames_.Count(FrameType::kState), 2u);
}

TEST_F(HistoryEncoderTest, AReaderCanBeginAtEveryState) {
  Listen();
  std::vector<std::string> at_keyframe;  // what the tree is like there
  for (int i = 0; i < 50; ++i) {
    for (int k = 0; k < 5; ++k) Tick();
    encoder_.Keyframe();
    const HistoryState now = encoder_.follower()->State(HistoryState::Cause::kKeyframe);
    EXPECT_EQ(now.statuses, executor_.statuses());
    at_keyframe.push_back(DescribeState(now.tick, now.time, now.statuses, now.values));
  }
  encoder_.Flush();
  std::size_t seen = 0;
  for (std::size_t first = 2; first < frames_.frames.size(); ++first) {
    if (frames_.types[first] != FrameType::kState) continue;
    HistoryDecoder decoder;
    KeptHistory history;
    decoder.SetTree({5, executor_.blackboard().size()});
    for (std::size_t i = first; i < frames_.frames.size(); ++i) {
      ASSERT_EQ(
          decoder.Decode(frames_.frames[i].data(), frames_.frames[i].size(), history).problem(),
          "");
    }
    EXPECT_EQ(history.lines[0], at_keyframe[seen++]);
    for (std::size_t i = 1; i < history.lines.size(); ++i) {
      EXPECT_EQ(history.lines[i], *(kept_.lines.end() - static_cast<long>(history.lines.size()) +
                                    static_cast<long>(i)));
    }
  }
  EXPECT_EQ(seen, at_keyframe.size());
}

TEST_F(HistoryEncoderTest, PutsStatesInByItself) {
  HistoryOptions options;
  options.keyframe_bytes = 1000;
  options.frame_bytes = 100;
  HistoryEncoder encoder(options, frames_);
  EncodingListener listener(encoder);
  stream_.Add(listener);
  for (int i = 0; i < 500; ++i) TickAtRandom(random_, script_, clock_, executor_);
  stream_.Remove(listener);
  EXPECT_GT(frames_.Count(FrameType::kState), 10u);
  EXPECT_GT(frames_.Count(FrameType::kEvents), 5 * frames_.Count(FrameType::kState));
}

TEST_F(HistoryEncoderTest, CountsWhatIsSkippedAndGivesTheStateBehindIt) {
  Listen();
  Tick();
  stream_.Remove(listener_);
  class Skipper : public EventListener {
   public:
    explicit Skipper(HistoryEncoder& encoder) : encoder_(encoder) {}
    void OnState(const StreamState&) override {}
    void OnTick(const TickEvents& events) override { encoder_.Skip(events); }
    HistoryEncoder& encoder_;
  } skipper(encoder_);
  stream_.Add(skipper);
  clock_.Advance(Duration(1));
  for (int i = 0; i < 5; ++i) executor_.Tick();
  stream_.Remove(skipper);
  encoder_.SkipNotes(2);
  stream_.Flush();

  encoder_.Note({Time(Duration(3)), "kind", "text"});
  KeptHistory history;
  EXPECT_EQ(frames_.DecodeAll(history).problem(), "");
  ASSERT_THAT(history.gaps, SizeIs(1));
  EXPECT_EQ(history.gaps[0].cause, HistoryGap::Cause::kOutput);
  EXPECT_EQ(history.gaps[0].lost_ticks, 5u);
  EXPECT_EQ(history.gaps[0].first_tick, executor_.ticks() - 4);
  EXPECT_EQ(history.gaps[0].last_tick, executor_.ticks());
  EXPECT_EQ(history.gaps[0].lost_notes, 2u);
  EXPECT_EQ(history.states.back().statuses, executor_.statuses());
  EXPECT_EQ(history.states.back().cause, HistoryState::Cause::kLost);
  EXPECT_EQ(history.lines.back(), "note 3 kind text");
  stream_.Add(listener_);
}

TEST_F(HistoryEncoderTest, ATreeThatWasSkippedIsDescribedLater) {
  StreamState state;
  state.program = executor_.shared_program();
  state.statuses = executor_.statuses();
  state.values.resize(executor_.blackboard().size());
  encoder_.Skip(state);
  EXPECT_THAT(frames_.frames, IsEmpty());
  encoder_.Note({Time(Duration(3)), "kind", "text"});
  EXPECT_THAT(frames_.types, ElementsAre(FrameType::kTree, FrameType::kState, FrameType::kNote));
  Listen();
}

TEST_F(HistoryEncoderTest, PassesOnWhatTheStreamHasLost) {
  Listen();
  StreamState state;
  state.cause = StreamState::Cause::kLost;
  state.program = executor_.shared_program();
  state.tick = 40;
  state.statuses = executor_.statuses();
  state.values.resize(executor_.blackboard().size());
  state.lost_ticks = 30;
  state.first_lost = 11;
  state.last_lost = 40;
  stream_.Flush();
  encoder_.Add(state);
  KeptHistory history;
  EXPECT_EQ(frames_.DecodeAll(history).problem(), "");
  ASSERT_THAT(history.gaps, SizeIs(1));
  EXPECT_EQ(history.gaps[0].cause, HistoryGap::Cause::kStream);
  EXPECT_EQ(history.gaps[0].lost_ticks, 30u);
  EXPECT_EQ(history.states.back().tick, 40u);
}

TEST_F(HistoryEncoderTest, GivesNoStateWithinATick) {
  Listen();
  Tick();
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kSuccess);
  encoder_.Add({9, Time(Duration(9)), Duration(0), Status::kIdle, false, words.words()});
  encoder_.Keyframe();
  EXPECT_EQ(frames_.Count(FrameType::kState), 1u);
  encoder_.Add({9, Time(Duration(9)), Duration(0), Status::kRunning, true, words.words()});
  encoder_.Keyframe();
  EXPECT_EQ(frames_.Count(FrameType::kState), 2u);
}

// Bytes per status change if each tick is a frame of its own, as at 10 Hz.
double BytesPerChange(const std::string& children, int ticks) {
  LeafScript script;
  SimulatedClock clock;
  Executor executor(CompileScripted(script, R"(<root BTCPP_format="4"><BehaviorTree ID="T">)" +
                                                children + "</BehaviorTree></root>"),
                    clock);
  std::mt19937 random(1);
  script.status = [&random] { return random() % 20 ? Status::kSuccess : Status::kFailure; };
  script.write = true;
  EventStream stream(executor);
  KeptFrames frames;
  HistoryEncoder encoder({}, frames);
  EncodingListener listener(encoder);
  stream.Add(listener);
  stream.Flush();
  std::uint64_t changes = 0;
  HistoryFollower follower = *encoder.follower();
  class Counter : public EventListener {
   public:
    Counter(HistoryFollower& follower, std::uint64_t& changes)
        : follower_(follower), changes_(changes) {}
    void OnState(const StreamState&) override {}
    void OnTick(const TickEvents& events) override {
      follower_.Apply(
          events, [this](const StatusChange&) { ++changes_; }, [](const Event&) {});
    }

   private:
    HistoryFollower& follower_;
    std::uint64_t& changes_;
  } counter(follower, changes);
  stream.Add(counter);
  for (int i = 0; i < ticks; ++i) {
    clock.Advance(Duration(100000000 - 50000 + random() % 100000));
    script.ratio = i * 0.1;
    executor.Tick();
    stream.Flush();
    encoder.Flush();
  }
  stream.Remove(counter);
  stream.Remove(listener);
  return static_cast<double>(frames.bytes) / static_cast<double>(changes);
}

TEST(HistorySize, IsSmallForASmallTreeThatTicksRarely) {
  const double bytes = BytesPerChange(R"(<ReactiveSequence>
      <Scripted ratio="{battery}"/><Scripted/>
      <Fallback><Inverter><Scripted/></Inverter><Scripted/></Fallback>
    </ReactiveSequence>)",
                                      500);
  EXPECT_LE(bytes, 4);
}

TEST(HistorySize, IsSmallForALargeTree) {
  std::string leaves;
  for (int i = 0; i < 300; ++i) leaves += "<ForceSuccess><Scripted/></ForceSuccess>";
  EXPECT_LE(BytesPerChange("<Sequence>" + leaves + "</Sequence>", 200), 0.5);
}

TEST_F(HistoryEncoderTest, EndsBehindAllEvents) {
  Listen();
  Tick();
  encoder_.End(HistoryEnd::Cause::kClosed, Time(Duration(5)));
  KeptHistory history;
  EXPECT_EQ(frames_.DecodeAll(history).problem(), "");
  EXPECT_EQ(history.lines.back(), "end " + std::to_string(executor_.ticks()));
}

}  // namespace
}  // namespace coppice
