#include "editor/document/suggested_model.h"

#include <gtest/gtest.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Race><Careful speed="2"><IsReady/></Careful>
      <Drive to="{goal}" speed="0.5" quiet="true" _skipIf="x" name="there"/>
      <Drive to="" speed="1" gait="trot"/><Issue/><Condition ID="Battery"/></Race>
  </BehaviorTree>
</root>)";

NodeModel Suggested(const std::string& type) { return SuggestModel({Parsed(kFile)}, type); }

TEST(SuggestedModel, TheKindFollowsFromChildrenNameAndTag) {
  EXPECT_EQ(Suggested("Race").category, NodeCategory::kControl);
  EXPECT_EQ(Suggested("Careful").category, NodeCategory::kDecorator);
  EXPECT_EQ(Suggested("IsReady").category, NodeCategory::kCondition);
  EXPECT_EQ(Suggested("Battery").category, NodeCategory::kCondition);
  EXPECT_EQ(Suggested("Issue").category, NodeCategory::kAction);
}

TEST(SuggestedModel, PortsAreWhatTheNodesAreGiven) {
  std::string ports;
  for (const PortModel& port : Suggested("Drive").ports) ports += port.name + ":" + port.type + " ";
  EXPECT_EQ(ports, "to: speed:double quiet:bool gait:string ");
}

}  // namespace
}  // namespace coppice::editor
