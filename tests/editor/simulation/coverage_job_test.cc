#include "editor/simulation/coverage_job.h"

#include <gtest/gtest.h>

#include "bt_core/frames/tree_description.h"
#include "tests/editor/simulation/simulated_text.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = R"(<Fallback><IsDay/><Go name="go"/><AlwaysSuccess/><Never/></Fallback>)";

class CoverageJobTest : public testing::Test {
 protected:
  CoverageJobTest() : program_(CompiledRoot(kTree)) {
    tree_ = DescribeTree(*program_, {});
    scene_.nodes.resize(tree_.nodes.size() + 1);
    for (NodeIndex i{0}; i < tree_.nodes.size(); ++i) scene_.nodes[i].run_node = i;
    scene_.nodes.back().run_node = kNoNode;  // was added since
  }
  void RunAll(std::uint64_t runs) {
    job_.Start(program_, {}, runs);
    while (job_.is_running()) job_.Update();
  }

  std::shared_ptr<const Program> program_;
  TreeDescription tree_;
  Scene scene_;
  CoverageJob job_;
};

TEST_F(CoverageJobTest, DoesAllRunsInPieces) {
  EXPECT_EQ(job_.coverage(), nullptr);
  job_.Start(program_, {}, 100000);
  job_.Update();
  EXPECT_TRUE(job_.is_running()) << "a frame does not wait for all";
  EXPECT_GE(job_.coverage()->runs, 1U);
  RunAll(200);
  EXPECT_EQ(job_.coverage()->runs, 200U);
  EXPECT_EQ(job_.Find("go")->ticks(), job_.coverage()->nodes[2].ticks());
  ASSERT_NE(job_.Find("Never::5"), nullptr);
  EXPECT_EQ(job_.Find("Never::5")->ticks(), 0U);
  EXPECT_EQ(job_.Find("gone"), nullptr);
  job_.Clear();
  EXPECT_EQ(job_.coverage(), nullptr);
}

TEST_F(CoverageJobTest, HeatIsHowOftenANodeWasTicked) {
  RunAll(500);
  const HeatMap map = job_.Heat(HeatMode::kTicks, tree_, scene_);
  EXPECT_EQ(map.values[0], 1.0F) << "the root is ticked most often";
  EXPECT_GT(map.values[2], map.values[1]) << "going takes many ticks";
  EXPECT_GT(map.values[1], map.values[3]);
  EXPECT_EQ(map.values[4], -1.0F) << "never ticked";
  EXPECT_EQ(map.values[5], -1.0F) << "not in the tree that was run";
}

TEST_F(CoverageJobTest, HeatIsWhatFailed) {
  RunAll(500);
  const HeatMap map = job_.Heat(HeatMode::kFailures, tree_, scene_);
  EXPECT_NEAR(map.values[1], 0.5F, 0.1F);
  EXPECT_EQ(map.values[3], 0.0F);
  EXPECT_EQ(job_.Heat(HeatMode::kNeverTicked, tree_, scene_).values[1], 0.0F);
}

}  // namespace
}  // namespace coppice::editor
