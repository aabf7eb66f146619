#include "bt_core/engine/models.h"
#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class NodesTest : public CliTest {};

TEST_F(NodesTest, ListsTheNodes) {
  EXPECT_EQ(Run(RunNodes, {}), 0);
  EXPECT_EQ(out_, DescribeNodes(Registry()));
}

TEST_F(NodesTest, WritesModels) {
  EXPECT_EQ(Run(RunNodes, {"--xml"}), 0);
  EXPECT_EQ(out_, WriteModels(Registry()));
}

TEST_F(NodesTest, RefusesOtherOptions) { EXPECT_EQ(Run(RunNodes, {"--json"}), 2); }

}  // namespace
}  // namespace coppice
