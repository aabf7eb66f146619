#include "editor/live/run_figures.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

using std::chrono::milliseconds;

class RunFiguresTest : public testing::Test {
 protected:
  RunFiguresTest() {
    tree_.results["drive"] = Status::kRunning;
    for (int i = 0; i < 10; ++i) tree_.Tick();
    tree_.results["drive"] = Status::kFailure;
    tree_.Tick();
  }
  ExecutedTree tree_{kDoorTrees};
  coppice::editor::Run run_;
  Follow follow_{tree_.executor, run_};
  RunFigures figures_;
};

TEST_F(RunFiguresTest, CountsTheWholeRunOrAStretch) {
  figures_.Update(run_, {});
  EXPECT_EQ(figures_.Find("pass/Drive")->ticks, 11U);
  EXPECT_EQ(figures_.Find("pass/Drive")->results_of(Status::kFailure), 1U);
  EXPECT_EQ(figures_.Find("nobody"), nullptr);
  figures_.Update(run_, std::pair<Time, Time>{milliseconds(250), milliseconds(450)});
  EXPECT_EQ(figures_.Find("pass/Drive")->ticks, 3U);
  EXPECT_EQ(figures_.statistics().ticks, 3U);
}

TEST_F(RunFiguresTest, GrowWithTheRun) {
  figures_.Update(run_, {});
  const std::uint64_t before = figures_.statistics().ticks;
  for (int i = 0; i < 100; ++i) tree_.Tick();
  figures_.Update(run_, {});
  EXPECT_EQ(figures_.statistics().ticks, before + 100);
}

TEST_F(RunFiguresTest, MakeHeatOfTimeOfFailuresAndOfWhatIsNeverTicked) {
  const TreeDescription& tree = *run_.TracksAt(0).tree();
  Scene scene;
  scene.nodes.resize(tree.nodes.size());
  std::size_t drive = 0;
  std::size_t open = 0;
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    scene.nodes[i].run_node = i;
    if (tree.nodes[i].path == "pass/Drive") drive = i;
    if (tree.nodes[i].path == "OpenDoor") open = i;
  }
  figures_.Update(run_, {});
  EXPECT_EQ(figures_.Heat(HeatMode::kTime, tree, scene).values[drive], 1);
  EXPECT_GT(figures_.Heat(HeatMode::kFailures, tree, scene).values[drive], 0);
  EXPECT_LT(figures_.Heat(HeatMode::kNeverTicked, tree, scene).values[open], 0);
  EXPECT_EQ(figures_.Heat(HeatMode::kNeverTicked, tree, scene).values[drive], 0);
}

TEST_F(RunFiguresTest, APartOfARunIsARun) {
  const Recording part = PartOf(run_.recording(), 4, 8);
  EXPECT_EQ(part.ticks().size(), 4U);
  EXPECT_EQ(part.ticks()[0].number, 5U);
  EXPECT_EQ(part.Before(0).statuses, run_.recording().Before(4).statuses);
}

}  // namespace
}  // namespace coppice::editor
