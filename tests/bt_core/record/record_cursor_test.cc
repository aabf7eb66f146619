#include "bt_core/record/record_cursor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/record/record_series.h"
#include "tests/bt_core/frames/scripted_tree.h"
#include "tests/bt_core/record/whole_record.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

/// Writes what an encoder makes into a file.
class FileSink : public FrameSink {
 public:
  explicit FileSink(const std::string& path) : series_(path, 0) {}
  void OnFrame(const Frame& frame) override {
    Bytes bytes(frame.data, frame.data + frame.size);
    EXPECT_EQ(series_.Write(bytes).problem(), "");
  }

 private:
  RecordSeries series_;
};

/// How a tree stood after each tick and halt.
struct Moment {
  std::uint64_t tick;
  Time time;
  bool is_tick;
  std::string state;
  std::string events;
};

class RecordCursorTest : public ::testing::Test {
 protected:
  RecordCursorTest() : sink_(folder_.Path("run.coppice")) {
    options_.keyframe_bytes = 300;
    options_.keyframe_states = 1;
    options_.frame_bytes = 60;
  }

  class Listener : public EventListener {
   public:
    Listener(HistoryEncoder& encoder, std::vector<Moment>& moments)
        : encoder_(encoder), moments_(moments) {}
    void OnState(const StreamState& state) override { encoder_.Add(state); }
    void OnTick(const TickEvents& events) override {
      encoder_.Add(events);
      moments_.push_back({events.tick, events.start, events.result != Status::kIdle,
                          StateOf(*encoder_.follower()), Describe(events)});
    }

   private:
    HistoryEncoder& encoder_;
    std::vector<Moment>& moments_;
  };

  static std::string StateOf(const HistoryFollower& f) {
    return DescribeState(f.tick(), f.time(), f.statuses(), f.values());
  }

  std::unique_ptr<RecordReader> RecordTicks(int ticks) {
    SimulatedClock clock(5s);
    Executor executor(ScriptedProgram(script_), clock);
    EventStream stream(executor);
    HistoryEncoder encoder(options_, sink_);
    Listener listener(encoder, moments_);
    stream.Add(listener);
    for (int i = 0; i < ticks; ++i) {
      clock.Advance(1us);
      TickAtRandom(random_, script_, clock, executor);
    }
    stream.Remove(listener);
    encoder.End(HistoryEnd::Cause::kClosed, clock.Now());
    return OpenRecord(folder_.Path("run.coppice"));
  }

  const TemporaryFolder folder_;
  FileSink sink_;
  std::mt19937 random_{21};
  LeafScript script_;
  HistoryOptions options_;
  std::vector<Moment> moments_;
};

TEST_F(RecordCursorTest, GoesBehindAnyTick) {
  const auto record = RecordTicks(400);
  EXPECT_GT(record->keyframes().size(), 20u);
  RecordCursor cursor(*record);
  for (int i = 0; i < 1000; ++i) {
    const Moment& moment = moments_[random_() % moments_.size()];
    if (!moment.is_tick) continue;
    cursor.SeekTick(moment.tick);
    ASSERT_EQ(StateOf(cursor.state()), moment.state);
    ASSERT_EQ(Describe(cursor.events()), moment.events);
  }
}

TEST_F(RecordCursorTest, GoesToAnyTime) {
  const auto record = RecordTicks(400);
  RecordCursor cursor(*record);
  for (int i = 0; i < 1000; ++i) {
    const Time time =
        record->begin() + Duration(static_cast<std::int64_t>(random_() % (2 * 400 * 1000000ull)));
    auto behind = std::upper_bound(moments_.begin(), moments_.end(), time,
                                   [](Time t, const Moment& m) { return t < m.time; });
    cursor.SeekTime(time);
    if (behind == moments_.begin()) continue;
    ASSERT_EQ(StateOf(cursor.state()), (behind - 1)->state);
  }
}

TEST_F(RecordCursorTest, GoesOnFromAnyTick) {
  const auto record = RecordTicks(100);
  RecordCursor cursor(*record);
  for (std::size_t i = 0; i < moments_.size(); ++i) {
    if (!moments_[i].is_tick) continue;
    cursor.SeekTick(moments_[i].tick);
    for (std::size_t next = i + 1; next < moments_.size() && next < i + 30; ++next) {
      ASSERT_EQ(cursor.Next(), RecordItem::kTick);
      ASSERT_EQ(Describe(cursor.events()), moments_[next].events);
      ASSERT_EQ(StateOf(cursor.state()), moments_[next].state);
    }
  }
}

TEST_F(RecordCursorTest, StaysWithinTheRecord) {
  const auto record = RecordTicks(50);
  RecordCursor cursor(*record);
  const std::string start = StateOf(cursor.state());
  cursor.SeekTick(1000000);
  EXPECT_EQ(StateOf(cursor.state()), moments_.back().state);
  EXPECT_EQ(cursor.Next(), RecordItem::kNone);
  cursor.SeekTick(0);
  EXPECT_EQ(StateOf(cursor.state()), start);
  EXPECT_EQ(cursor.events().tick, 0u);
  cursor.SeekTime(Time::max());
  EXPECT_EQ(StateOf(cursor.state()), moments_.back().state);
  cursor.SeekTime(Time::min());
  EXPECT_EQ(StateOf(cursor.state()), start);
  cursor.SeekLast();
  EXPECT_EQ(StateOf(cursor.state()), moments_.back().state);
  cursor.SeekBegin();
  EXPECT_EQ(StateOf(cursor.state()), start);
}

StreamState StateWith(std::shared_ptr<const Program> program, StreamState::Cause cause,
                      std::uint64_t tick) {
  StreamState state;
  state.cause = cause;
  state.program = std::move(program);
  state.tick = tick;
  state.time = Time(tick * 1s);
  state.statuses.resize(state.program->nodes.size());
  state.values.resize(state.program->layout.slots.size());
  return state;
}

TickEvents Tick(std::uint64_t number, const EventWriter& words, bool is_whole = true) {
  return {number, Time(number * 1s), 0us, Status::kRunning, is_whole, words.words()};
}

std::vector<RecordItem> ItemsOf(RecordCursor& cursor) {
  std::vector<RecordItem> items;
  for (RecordItem item = cursor.Next(); item != RecordItem::kNone; item = cursor.Next()) {
    items.push_back(item);
  }
  return items;
}

TEST_F(RecordCursorTest, TellsWhatIsNoTick) {
  HistoryEncoder encoder({}, sink_);
  EventWriter words;
  words.Status(NodeIndex{1}, Status::kSuccess);
  words.Status(kRootNode, Status::kRunning);
  const auto program = ScriptedProgram(script_);
  encoder.Add(StateWith(program, StreamState::Cause::kBegin, 0));
  encoder.Add(Tick(1, words));
  encoder.Note({Time(1s), "fault", "laser"});
  encoder.Skip(Tick(2, words));
  encoder.Add(Tick(3, words));
  encoder.Keyframe();
  encoder.Add(Tick(4, words));
  encoder.Add(StateWith(OtherScriptedProgram(script_), StreamState::Cause::kJump, 4));
  encoder.Add(Tick(5, words));
  encoder.End(HistoryEnd::Cause::kClosed, Time(6s));

  const auto record = OpenRecord(folder_.Path("run.coppice"));
  RecordCursor cursor(*record);
  EXPECT_THAT(ItemsOf(cursor), ElementsAre(RecordItem::kTick, RecordItem::kNote, RecordItem::kGap,
                                           RecordItem::kState, RecordItem::kTick, RecordItem::kTick,
                                           RecordItem::kTree, RecordItem::kTick, RecordItem::kEnd));
  EXPECT_EQ(cursor.note().text, "laser");
  EXPECT_EQ(cursor.gap().first_tick, 2u);
  EXPECT_EQ(cursor.end().time, Time(6s));
  EXPECT_EQ(cursor.tree().nodes[2].path, "new");
  cursor.SeekTick(3);
  EXPECT_EQ(cursor.tree().nodes[2].path, "Fallback::3");
}

TEST_F(RecordCursorTest, CollectsATickThatCameInParts) {
  HistoryEncoder encoder({}, sink_);
  encoder.Add(StateWith(ScriptedProgram(script_), StreamState::Cause::kBegin, 0));
  EventWriter first;
  first.Status(NodeIndex{1}, Status::kSuccess);
  EventWriter second;
  second.Status(NodeIndex{3}, Status::kRunning);
  second.Status(NodeIndex{2}, Status::kRunning);
  EventWriter third;
  third.Status(kRootNode, Status::kRunning);
  encoder.Add(Tick(1, first, false));
  encoder.Flush();
  encoder.Add(Tick(1, second, false));
  encoder.Flush();
  encoder.Add(Tick(1, third));
  encoder.Add(Tick(2, third));
  encoder.End(HistoryEnd::Cause::kClosed, Time(6s));

  EventWriter all;
  all.Status(NodeIndex{1}, Status::kSuccess);
  all.Status(NodeIndex{3}, Status::kRunning);
  all.Status(NodeIndex{2}, Status::kRunning);
  const std::string so_far = Describe(Tick(1, all, false));
  all.Status(kRootNode, Status::kRunning);
  const auto record = OpenRecord(folder_.Path("run.coppice"));
  RecordCursor cursor(*record);
  cursor.Next();
  EXPECT_EQ(Describe(cursor.events()), Describe(Tick(1, first, false)));
  cursor.Next();
  EXPECT_EQ(Describe(cursor.events()), so_far);
  EXPECT_EQ(cursor.state().status(NodeIndex{3}), Status::kRunning);
  cursor.Next();
  EXPECT_EQ(Describe(cursor.events()), Describe(Tick(1, all)));
  cursor.Next();
  EXPECT_EQ(Describe(cursor.events()), Describe(Tick(2, third)));
  cursor.SeekTick(1);
  EXPECT_EQ(Describe(cursor.events()), Describe(Tick(1, all)));
}

TEST_F(RecordCursorTest, SaysWhereSomethingIsDamagedAndGivesTheStateBehindIt) {
  const auto record = RecordTicks(200);
  const std::string path = folder_.Path("run.coppice");
  std::string bytes = ReadFile(path);
  const RecordKeyframe keyframe = record->keyframes()[5];
  bytes[record->keyframes()[4].offset + 30] ^= 1;
  bytes[record->keyframes()[8].offset - 5] ^= 1;
  WriteFile(path, bytes);
  const auto damaged = OpenRecord(path);
  RecordCursor cursor(*damaged);
  std::vector<RecordItem> items = ItemsOf(cursor);
  EXPECT_EQ(std::count(items.begin(), items.end(), RecordItem::kDamage), 2);
  for (auto at = items.begin(); at != items.end(); ++at) {
    if (*at == RecordItem::kDamage) {
      EXPECT_EQ(at[1], RecordItem::kState);
    }
  }
  EXPECT_THAT(cursor.damages(), SizeIs(2));
  EXPECT_EQ(cursor.damages()[0].offset, record->keyframes()[4].offset);
  EXPECT_EQ(StateOf(cursor.state()), moments_.back().state);
  cursor.SeekTick(keyframe.tick + 1);
  EXPECT_THAT(cursor.damages(), SizeIs(0)) << "it is not on the way";
}

TEST_F(RecordCursorTest, AllNodesAreIdleWhereTheStateIsDamaged) {
  const auto record = RecordTicks(200);
  const std::string path = folder_.Path("run.coppice");
  std::string bytes = ReadFile(path);
  const auto damaged = OpenRecord(path);
  const RecordKeyframe last = damaged->keyframes().back();
  bytes[last.offset + 20] ^= 1;  // only now: opening looks at the sums of states
  WriteFile(path, bytes);
  RecordCursor cursor(*damaged);
  cursor.SeekTime(last.time + 1ns);
  EXPECT_THAT(cursor.damages(), SizeIs(1));
  EXPECT_THAT(cursor.state().statuses(), SizeIs(cursor.tree().nodes.size()));
  EXPECT_THAT(cursor.state().values(), SizeIs(cursor.tree().slots.size()));
  EXPECT_EQ(cursor.state().status(kRootNode), Status::kIdle);
  EXPECT_EQ(cursor.state().tick(), last.tick);
}

}  // namespace
}  // namespace coppice
