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
  EXPECT_EQ(program_.Id(0), "Sequence");
  EXPECT_EQ(program_.Id(1), "Tell");
  EXPECT_EQ(program_.Id(2), "S");
  EXPECT_EQ(program_.Id(3), "Tell");
}

TEST_F(ProgramTest, NameIsGivenOrElseTheId) {
  EXPECT_EQ(program_.Name(1), "Tell");
  EXPECT_EQ(program_.Name(2), "patrol");
  EXPECT_EQ(program_.Name(3), "speak");
}

TEST_F(ProgramTest, PathsLeadThroughTheInstances) {
  EXPECT_EQ(program_.Path(0), "Sequence::1");
  EXPECT_EQ(program_.Path(3), "patrol/speak");
  EXPECT_EQ(program_.Path(5), "S::5/speak");
}

TEST_F(ProgramTest, LocationIsWhereTheNodeIsWritten) {
  EXPECT_EQ(program_.Location(1).line, 4U);
  EXPECT_EQ(program_.Location(1).column, 2U);
  EXPECT_EQ(program_.Location(3).line, 7U);
}

TEST_F(ProgramTest, ScopesBearThePathsOfTheInstances) {
  EXPECT_EQ(program_.layout.scopes, (std::vector<std::string>{"Main", "patrol", "S::5"}));
}

}  // namespace
}  // namespace coppice
