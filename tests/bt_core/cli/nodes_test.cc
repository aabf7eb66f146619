#include <cstdlib>

#include "bt_core/engine/compile/models.h"
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

// By another program that knows XML schemas.
TEST_F(NodesTest, WritesASchemaThatTellsRightFromWrong) {
  ASSERT_EQ(Run(RunNodes, {"--xsd"}), 0);
  const std::string schema = Write("nodes.xsd", out_);
  const auto is_valid = [&](const std::string& body) {
    const std::string command =
        "xmllint --noout --schema " + schema + " " + WriteTree(body) + " > /dev/null 2>&1";
    return std::system(command.c_str()) == 0;
  };
  EXPECT_TRUE(is_valid(R"(<Sequence name="s" _skipIf="a"><Sleep msec="100"/>)"
                       R"(<Sleep msec="{time}"/><SubTree ID="Other" goal="{g}"/>)"
                       R"(<Action ID="Drive" speed="1"/></Sequence>)"));
  EXPECT_TRUE(is_valid(R"(<Precondition if="a" else="SUCCESS"><AlwaysSuccess/></Precondition>)"));
  EXPECT_FALSE(is_valid(R"(<Precondition if="a" else="GOOD"><AlwaysSuccess/></Precondition>)"));
  EXPECT_FALSE(is_valid(R"(<Sleep msec="soon"/>)"));
  EXPECT_FALSE(is_valid("<Sleep/>"));
  EXPECT_FALSE(is_valid("<Sequense><AlwaysSuccess/></Sequense>"));
  EXPECT_FALSE(is_valid("<Inverter/>"));
  EXPECT_FALSE(is_valid(R"(<AlwaysSuccess _skipif="a"/>)"));
}

TEST_F(NodesTest, RefusesOtherOptions) { EXPECT_EQ(Run(RunNodes, {"--json"}), 2); }

}  // namespace
}  // namespace coppice
