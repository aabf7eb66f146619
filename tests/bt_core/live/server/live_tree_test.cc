#include "bt_core/live/server/live_tree.h"

#include "bt_core/data/value_bytes.h"
#include "bt_core/frames/pause_note.h"
#include "tests/bt_core/live/desk_fixture.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class LiveTreeTest : public LiveTreeFixture {};

TEST_F(LiveTreeTest, KnowsStatusesAsTheGroot2ProtocolShowsThem) {
  EXPECT_THAT(tree_->ShownStatuses().items, ElementsAre(0, 0, 0, 0, 0, 0));
  Tick();
  EXPECT_THAT(tree_->ShownStatuses().items, ElementsAre(1, 2, 2, 12, 12, 1));
  Tick();
  EXPECT_THAT(tree_->ShownStatuses().items, ElementsAre(1, 2, 2, 13, 13, 1));
}

TEST_F(LiveTreeTest, DescribesItself) {
  Tick(3);
  const LiveTreeInfo info = tree_->Info();
  EXPECT_EQ(info.name, "Main");
  EXPECT_EQ(info.nodes, 6u);
  EXPECT_EQ(info.tick, 3u);
  EXPECT_EQ(info.lost_ticks, 0u);
  EXPECT_EQ(info.first_frame, 0u);
}

// Every tick stops at the leaf that follows the one that writes.
struct StoppedTreeTest : testing::Test {
  StoppedTreeTest() {
    stream_.Add(tree_);
    stream_.Flush();
    Hook hook;
    hook.node = NodeIndex{5};
    EXPECT_TRUE(tree_.debugger().Add(hook, LiveTree::kGroot2Owner));
  }
  ~StoppedTreeTest() override { stream_.Remove(tree_); }

  void OnWake() {
    for (const DebugEvent& event : tree_.TakeDebugEvents()) {
      if (event.kind != DebugEvent::Kind::kStopped) continue;
      std::string written;
      AppendValueBytes(executor_.blackboard()[number_].value, written);
      EXPECT_EQ(tree_.Values().items[number_], written) << "stop " << stops_;
      ++stops_;
      clock_.Advance(std::chrono::seconds(2));
      tree_.debugger().Continue(std::nullopt);
    }
  }

  SimulatedClock clock_{std::chrono::seconds(1)};
  Executor executor_{WatchedProgram(), clock_};
  EventStream stream_{executor_};
  const SlotIndex number_ = executor_.program().layout.Find(kMainScope, "number");
  int stops_ = 0;
  std::vector<HistoryNote> notes_;
  LiveTree tree_{stream_, Options(), [this] { OnWake(); }};

 private:
  LiveTreeOptions Options() {
    LiveTreeOptions options;
    options.on_note = [this](const HistoryNote& note) { notes_.push_back(note); };
    return options;
  }
};

TEST_F(StoppedTreeTest, IsSeenAsItStandsWhenTheStopIsTold) {
  for (int i = 0; i < 100; ++i) executor_.Tick();
  EXPECT_EQ(stops_, 100);
}

TEST_F(StoppedTreeTest, NotesHowLongTheTreeStood) {
  const Time start = clock_.Now();
  executor_.Tick();
  ASSERT_EQ(notes_.size(), 1u);
  EXPECT_EQ(notes_[0].time, start);
  const std::optional<Pause> pause = PauseOf(notes_[0]);
  ASSERT_TRUE(pause) << notes_[0].text;
  EXPECT_EQ(pause->to - pause->from, std::chrono::seconds(2));
  EXPECT_EQ(pause->tick, 1u);
  EXPECT_LT(pause->of_tick, std::chrono::seconds(2)) << "in real time, which did not jump";
}

TEST_F(StoppedTreeTest, TheHistoryForClientsTellsThePause) {
  executor_.Tick();
  const auto count = [](const FrameStore& frames) {
    int notes = 0;
    for (auto i = frames.first(); i < frames.next(); ++i) {
      notes += frames[i].type == FrameType::kNote;
    }
    return notes;
  };
  EXPECT_EQ(tree_.UseFrames(count), 1);
}

TEST_F(LiveTreeTest, CountsResults) {
  Tick(4);
  const auto counts = tree_->Counts().items;
  EXPECT_THAT(counts[0], ElementsAre(4, 0, 0, 0));
  EXPECT_THAT(counts[4], ElementsAre(0, 2, 2, 0));
}

TEST_F(LiveTreeTest, WritesValuesOfTheRightTypeOnly) {
  Tick();
  const auto value_of = [&](const char* key) {
    return executor_.blackboard()[executor_.program().layout.Find(kMainScope, key)].value.Print();
  };
  EXPECT_EQ(tree_->Write("", "text", "\"a \\\"b\"", false).problem(), "");
  EXPECT_EQ(tree_->Write("Main", "number", "12", true).problem(), "");
  executor_.RunCalls();
  executor_.inbox()->RequestTick();
  Tick();
  EXPECT_EQ(value_of("number"), "2") << "the leaf has written since";
  EXPECT_THAT(tree_->Write("", "number", "\"x\"", false).problem(), HasSubstr("key \"number\""));
  EXPECT_THAT(tree_->Write("", "number", "x", true).problem(), HasSubstr("x is no int"));
  EXPECT_THAT(tree_->Write("", "spot", "1;2", true).problem(), HasSubstr("is no Spot"));
  EXPECT_THAT(tree_->Write("inner", "said", "\"x\"", false).problem(),
              HasSubstr("no key \"said\" of its own"));
  EXPECT_THAT(tree_->Write("nobody", "text", "\"x\"", false).problem(), HasSubstr("nobody"));
}

TEST_F(LiveTreeTest, AWrittenValueIsThereBeforeTheNodesAreTicked) {
  EXPECT_EQ(tree_->Write("inner", "literal", "9", false).problem(), "");
  Tick();
  const auto& layout = executor_.program().layout;
  EXPECT_EQ(executor_.blackboard()[layout.Find(ScopeIndex{1}, "literal")].value.Print(), "9");
}

// No node says which type "battery" has.
class ScriptedTreeTest : public testing::TestWithParam<std::pair<const char*, bool>> {
 protected:
  ScriptedTreeTest() {
    stream_.Add(tree_);
    stream_.Flush();
  }
  ~ScriptedTreeTest() override { stream_.Remove(tree_); }

  SimulatedClock clock_;
  Executor executor_{CompileText(R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
      <ScriptCondition code="battery == 21"/></BehaviorTree></root>)"),
                     clock_};
  EventStream stream_{executor_};
  LiveTree tree_{stream_, {}, [] {}};
};

TEST_P(ScriptedTreeTest, AKeyThatOnlyScriptsUseTakesWhatItIsGiven) {
  const auto& [value, is_text] = GetParam();
  EXPECT_EQ(tree_.Write("", "battery", value, is_text).problem(), "");
  EXPECT_EQ(executor_.Tick(), Status::kSuccess);
}

INSTANTIATE_TEST_SUITE_P(Values, ScriptedTreeTest,
                         testing::Values(std::pair("21", true), std::pair("21", false),
                                         std::pair("2.1e1", true), std::pair("2.1e1", false)));

TEST_P(ScriptedTreeTest, AKeyThatOnlyScriptsUseTakesNoObject) {
  EXPECT_THAT(tree_.Write("", "battery", "{}", false).problem(), HasSubstr("a number, a text"));
}

TEST_F(LiveTreeTest, FollowsAnotherProgram) {
  const groot2::TreeId id = tree_->id();
  EXPECT_FALSE(tree_->TakeProgramChange());
  executor_.Reload(
      CompileText("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Other\">"
                  "<AlwaysSuccess/></BehaviorTree></root>"));
  Tick();
  EXPECT_TRUE(tree_->TakeProgramChange());
  EXPECT_FALSE(tree_->TakeProgramChange());
  EXPECT_NE(tree_->id(), id);
  EXPECT_EQ(tree_->ShownStatuses().items.size(), 1u);
  EXPECT_EQ(tree_->ShownStatuses().program.get(), &executor_.program());
}

TEST_F(LiveTreeTest, EndsItsHistoryOnce) {
  tree_->EndHistory();
  const std::uint64_t frames = tree_->Info().next_frame;
  tree_->EndHistory();
  EXPECT_EQ(tree_->Info().next_frame, frames);
  tree_->UseFrames(
      [&](const FrameStore& store) { EXPECT_EQ(store[store.next() - 1].type, FrameType::kEnd); });
}

TEST_F(LiveTreeTest, RecordsTransitionsForGroot2) {
  const std::uint64_t start = tree_->StartRecording();
  EXPECT_GT(start, 1'600'000'000'000'000u);
  Tick();
  tree_->StopRecording();
  EXPECT_GT(tree_->TakeTransitions().size(), 9u * 5);
}

TEST_F(LiveTreeTest, WakesTheServerForSubscribersOnly) {
  wakes_ = 0;
  Tick();
  EXPECT_EQ(wakes_, 0);
  tree_->CountSubscribers(1);
  Tick();
  EXPECT_GT(wakes_, 0);
}

struct Tree : LiveTreeFixture {
  explicit Tree(const LiveTreeOptions& options) : LiveTreeFixture(options) {}
  void TestBody() override {}
  using LiveTreeFixture::tree_;
};

TEST(LiveTree, BearsTheRunThatItIsGiven) {
  LiveTreeOptions options;
  options.run.fill(7);
  EXPECT_EQ(Tree(options).tree_->run(), options.run);
  EXPECT_NE(Tree({}).tree_->run(), Tree({}).tree_->run());
}

TEST(LiveTree, RefusesWithTheReason) {
  EXPECT_EQ(Tree(Moving()).tree_->Permission().problem(), "the robot moves");
  EXPECT_THAT(Tree(ReadOnly()).tree_->Permission().problem(), HasSubstr("read-only"));
  EXPECT_EQ(Tree({}).tree_->Permission().problem(), "");
  LiveTreeOptions broken;
  broken.permission = []() -> Outcome { throw std::runtime_error("no odometry"); };
  EXPECT_THAT(Tree(broken).tree_->Permission().problem(), HasSubstr("no odometry"));
}

}  // namespace
}  // namespace coppice
