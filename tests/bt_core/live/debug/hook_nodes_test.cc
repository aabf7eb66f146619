#include "bt_core/live/debug/hook_nodes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HookNodesTest : public ::testing::Test {
 protected:
  Stage stage_{Root(R"(
      <BehaviorTree ID="Main"><Sequence name="top">
        <AlwaysSuccess/>
        <SubTree ID="Dock" name="dock"/>
      </Sequence></BehaviorTree>
      <BehaviorTree ID="Dock"><Sequence><AlwaysSuccess/><AlwaysSuccess/></Sequence>
      </BehaviorTree>)")};
  const Program& program_ = *stage_.program;
};

TEST_F(HookNodesTest, PathsAreThoseOfTheProgram) {
  for (NodeIndex i{0}; i < program_.nodes.size(); ++i) {
    EXPECT_THAT(FindNodes(program_, program_.Path(i)), ElementsAre(i));
  }
}

TEST_F(HookNodesTest, TheMainTreeMayStandInFront) {
  EXPECT_THAT(FindNodes(program_, "Main/top"), ElementsAre(0u));
  EXPECT_THAT(FindNodes(program_, "Main/dock"), ElementsAre(2u));
}

TEST_F(HookNodesTest, ATypeStandsForAllItsNodesInTheInstance) {
  EXPECT_THAT(FindNodes(program_, "AlwaysSuccess"), ElementsAre(1u));
  EXPECT_THAT(FindNodes(program_, "dock/AlwaysSuccess"), ElementsAre(4u, 5u));
}

TEST_F(HookNodesTest, AMissingNodeIsDescribedWithTheNearestPath) {
  EXPECT_THAT(FindNodes(program_, "dok"), IsEmpty());
  EXPECT_THAT(FindNodes(program_, "Main/"), IsEmpty());
  EXPECT_THAT(DescribeMissingNode(program_, "dok"), HasSubstr(R"(did you mean "dock"?)"));
}

}  // namespace
}  // namespace coppice
