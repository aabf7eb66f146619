#include "bt_core/engine/program.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

class ProgramTest : public testing::Test {
 protected:
  Stage stage_{
      Root("<BehaviorTree ID=\"Main\">\n<Sequence>\n <Tell text=\"x\"/>\n"
           " <SubTree ID=\"S\" name=\"patrol\"/>\n <SubTree ID=\"S\"/></Sequence></BehaviorTree>\n"
           R"(<BehaviorTree ID="S"><Action ID="Tell" name="speak" text="y"/></BehaviorTree>)")};
  const Program& program_ = *stage_.program;
};

TEST_F(ProgramTest, IdIsTheRegistrationOrTheTree) {
  EXPECT_EQ(program_.Id(kRootNode), "Sequence");
  EXPECT_EQ(program_.Id(NodeIndex{1}), "Tell");
  EXPECT_EQ(program_.Id(NodeIndex{2}), "S");
  EXPECT_EQ(program_.Id(NodeIndex{3}), "Tell");
}

TEST_F(ProgramTest, NameIsGivenOrElseTheId) {
  EXPECT_EQ(program_.Name(NodeIndex{1}), "Tell");
  EXPECT_EQ(program_.Name(NodeIndex{2}), "patrol");
  EXPECT_EQ(program_.Name(NodeIndex{3}), "speak");
}

TEST_F(ProgramTest, PathsLeadThroughTheInstances) {
  EXPECT_EQ(program_.Path(kRootNode), "Sequence::1");
  EXPECT_EQ(program_.Path(NodeIndex{3}), "patrol/speak");
  EXPECT_EQ(program_.Path(NodeIndex{5}), "S::5/speak");
}

TEST_F(ProgramTest, LocationIsWhereTheNodeIsWritten) {
  EXPECT_EQ(program_.Location(NodeIndex{1}).line, 4U);
  EXPECT_EQ(program_.Location(NodeIndex{1}).column, 2U);
  EXPECT_EQ(program_.Location(NodeIndex{3}).line, 7U);
}

TEST_F(ProgramTest, ScopesBearThePathsOfTheInstances) {
  EXPECT_EQ(program_.layout.scopes, (std::vector<std::string>{"Main", "patrol", "S::5"}));
}

}  // namespace
}  // namespace coppice
