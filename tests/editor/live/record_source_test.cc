#include "editor/live/record_source.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/load_recording.h"
#include "bt_core/record/recorder.h"
#include "editor/live/run_view.h"
#include "editor/workspace/workspace.h"
#include "tests/editor/timeline/executed_run.h"
#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

constexpr char kTrees[] = R"(<BehaviorTree ID="Main"><ReactiveSequence>
  <Is as="ready"/><Do as="work" count="{count}"/></ReactiveSequence></BehaviorTree>)";

class RecordSourceTest : public testing::Test {
 protected:
  // Half of the ticks succeed, in blocks of ten.
  void Record(int ticks) {
    EventStream stream(robot_.executor);
    Recorder recorder(stream, path_);
    for (int i = 0; i < ticks; ++i) {
      robot_.results["ready"] = i / 10 % 2 == 0 ? Status::kSuccess : Status::kFailure;
      robot_.Tick();
      if (i % 100 == 99) stream.Flush();
    }
    EXPECT_EQ(recorder.Close().problem(), "");
  }

  // The run after it was read to its end.
  static void ReadAll(RunView& view) {
    double now = 0;
    do {
      view.Update(HookList(), now += 0.02);
    } while (view.source().has_news());
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_.Path("run.coppice");
  ExecutedTree robot_{kTrees};
  Diagnostics diagnostics_;
};

TEST_F(RecordSourceTest, TellsARecordToTheEnd) {
  Record(1000);
  auto source = RecordSource::Open(path_, diagnostics_);
  ASSERT_NE(source, nullptr) << diagnostics_.ToString();
  RunView view(std::move(source), std::make_shared<NodeModels>());
  EXPECT_EQ(view.phase(), RunPhase::kLoading);
  ReadAll(view);
  EXPECT_EQ(view.phase(), RunPhase::kRecord);
  EXPECT_EQ(view.source().progress(), 1);
  EXPECT_EQ(view.run().size(), 1000U);
  EXPECT_TRUE(view.run().breaks().empty());
  view.playhead().GoToTick(15);
  view.Update(HookList(), 100);
  EXPECT_EQ(view.state().states[1].before, Status::kFailure);
  EXPECT_TRUE(view.run().recording().is_closed());
}

TEST_F(RecordSourceTest, AShortRecordMayNotTakeAllTheMemoryOfARun) {
  Record(1000);
  const auto source = RecordSource::Open(path_, diagnostics_);
  ASSERT_NE(source, nullptr) << diagnostics_.ToString();
  EXPECT_LT(source->most_bytes(), kMostRunBytes / 4);
}

TEST_F(RecordSourceTest, FollowsARecordThatGrows) {
  EventStream stream(robot_.executor);
  Recorder recorder(stream, path_);
  const auto await = [&](std::uint64_t tick) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (recorder.flushed_tick() < tick && std::chrono::steady_clock::now() < end) stream.Flush();
  };
  robot_.Tick();
  await(1);
  auto opened = RecordSource::Open(path_, diagnostics_);
  ASSERT_NE(opened, nullptr) << diagnostics_.ToString();
  RecordSource& source = *opened;
  RunView view(std::move(opened), std::make_shared<NodeModels>());
  ReadAll(view);
  EXPECT_EQ(view.run().size(), 1U);
  robot_.Tick();
  await(2);
  source.Refresh();
  ReadAll(view);
  EXPECT_EQ(view.run().size(), 2U);
}

TEST_F(RecordSourceTest, ReadsALogOfBehaviorTreeCpp) {
  Record(30);
  const std::optional<Recording> run = LoadRecording(path_, diagnostics_);
  ASSERT_TRUE(run);
  const std::string log = folder_.Path("run.btlog");
  std::ofstream(log, std::ios::binary) << ToBtlog(*run, diagnostics_).value();
  auto source = RecordSource::Open(log, diagnostics_);
  ASSERT_NE(source, nullptr) << diagnostics_.ToString();
  RunView view(std::move(source), std::make_shared<NodeModels>());
  ReadAll(view);
  EXPECT_GT(view.run().size(), 20U);
  ASSERT_NE(view.tree(), nullptr);
  EXPECT_EQ(view.tree()->description()->nodes.size(), 3U);
}

TEST_F(RecordSourceTest, SaysWhatIsWrongWithAFile) {
  std::ofstream(path_) << "this is no record";
  EXPECT_EQ(RecordSource::Open(path_, diagnostics_), nullptr);
  EXPECT_TRUE(diagnostics_.has_errors());
  Diagnostics of_log;
  EXPECT_EQ(RecordSource::Open("/nowhere.btlog", of_log), nullptr);
  EXPECT_TRUE(of_log.has_errors());
}

TEST_F(RecordSourceTest, CannotBeChanged) {
  Record(3);
  auto source = RecordSource::Open(path_, diagnostics_);
  ASSERT_NE(source, nullptr);
  std::string error;
  source->Send(MakeCommand(LiveCommand::Kind::kPause),
               [&error](const LiveReply& reply) { error = reply.problem(); });
  EXPECT_NE(error, "");
  EXPECT_TRUE(IsRecordName("a/b.btlog"));
  EXPECT_FALSE(IsRecordName("a/b.xml"));
}

TEST_F(RecordSourceTest, ARecordThatWasClosedIsShownAtItsLastTick) {
  {
    EventStream stream(robot_.executor);
    Recorder recorder(stream, path_);
    for (int i = 0; i < 20; ++i) robot_.Tick();
    robot_.executor.Halt();
    EXPECT_EQ(recorder.Close().problem(), "");
  }
  RunView view(RecordSource::Open(path_, diagnostics_), std::make_shared<NodeModels>());
  ReadAll(view);
  view.Update(HookList(), 100);
  ASSERT_GT(view.run().size(), 20U) << "the halt is something of its own";
  EXPECT_FALSE(view.playhead().is_at_now());
  EXPECT_NE(view.run().recording().ticks()[view.playhead().tick()].result, Status::kIdle);
  EXPECT_NE(view.state().states[0].status, Status::kIdle);
}

TEST_F(RecordSourceTest, ARecordThatIsStillWrittenIsFollowed) {
  Record(1000);
  std::ifstream whole(path_, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(whole), {}};
  const std::string growing = folder_.Path("growing.coppice");
  std::ofstream writer(growing, std::ios::binary);
  std::size_t written = 0;
  const auto write = [&](std::size_t count) {
    writer << bytes.substr(written, count) << std::flush;
    written += count;
  };
  for (Diagnostics ignored; !RecordSource::Open(growing, ignored);) write(16);
  Workspace workspace([](const Scene&, const SceneNode&) { return Point{100, 30}; });
  ASSERT_TRUE(workspace.Open(growing, 0));
  double now = 0;
  const auto read = [&] {
    for (const double end = now + 2; now < end;) workspace.Update(now += 0.02);
  };
  read();
  const std::size_t before = workspace.run()->run().size();
  EXPECT_LT(before, 1000U);
  EXPECT_LE(workspace.NextUpdateIn(now), 0.5) << "it looks again";
  EXPECT_TRUE(workspace.run()->playhead().is_at_now());
  write(bytes.size());
  read();
  EXPECT_EQ(workspace.run()->run().size(), 1000U);
  EXPECT_TRUE(workspace.run()->run().breaks().empty());
  EXPECT_EQ(workspace.run()->phase(), RunPhase::kRecord) << "not loading again";
  EXPECT_FALSE(workspace.run()->source().may_grow()) << "it was closed";
}

}  // namespace
}  // namespace coppice::editor
