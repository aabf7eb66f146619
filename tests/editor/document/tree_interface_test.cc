#include "editor/document/tree_interface.h"

#include <gtest/gtest.h>

#include "tests/editor/document/drafts.h"

namespace coppice::editor {
namespace {

constexpr char kModels[] = R"(<TreeNodesModel>
  <Action ID="Plan"><input_port name="to" type="Pose2D"/><output_port name="path"/></Action>
  <Action ID="Follow"><input_port name="path"/><output_port name="driven" type="double"/></Action>
  <Action ID="Count"><inout_port name="times" type="int"/></Action>
</TreeNodesModel>)";

// "in goal Pose2D, out metres"; those that are declared with a '!'.
std::string InterfaceIn(const std::string& trees, const std::string& id) {
  const ProjectFiles files = {Parsed("<root BTCPP_format=\"4\">" + trees + kModels + "</root>")};
  NodeModels models;
  models.AddFrom(files[0]);
  std::string text;
  for (const InterfacePort& port : InterfaceOf(files, models, id)) {
    text += (text.empty() ? "" : ", ") + std::string(ToString(port.model.direction)) + " " +
            port.model.name + (port.model.type.empty() ? "" : " " + port.model.type) +
            (port.declared ? "!" : "");
  }
  return text;
}

std::string InterfaceOfNodes(const std::string& nodes) {
  return InterfaceIn("<BehaviorTree ID=\"T\"><Sequence>" + nodes + "</Sequence></BehaviorTree>",
                     "T");
}

TEST(TreeInterface, WhatIsReadOrWrittenAloneIsShared) {
  EXPECT_EQ(InterfaceOfNodes(R"(<Plan to="{goal}" path="{p}"/><Follow path="{p}" driven="{m}"/>)"),
            "input goal Pose2D, output m double")
      << "p is written and read inside";
}

TEST(TreeInterface, WhatIsOnlyChangedIsBoth) {
  EXPECT_EQ(InterfaceOfNodes(R"(<Count times="{n}"/>)"), "inout n int");
}

TEST(TreeInterface, PrivateAndGlobalKeysAreNotShared) {
  EXPECT_EQ(InterfaceOfNodes(R"(<Plan to="{_goal}"/><Plan to="{@home}"/>)"), "");
}

TEST(TreeInterface, ScriptsCount) {
  EXPECT_EQ(InterfaceOfNodes(R"(<Script code="done := level > 3"/>)"), "output done, input level");
}

TEST(TreeInterface, AKeyThatOnlyUnknownNodesUseIsTheirsIfItIsSharedByThem) {
  EXPECT_EQ(InterfaceOfNodes(R"(<A x="{k}"/><B y="{k}"/><C z="{alone}"/>)"), "input alone");
}

TEST(TreeInterface, ASubTreeHandsOnWhatItsTreeDoes) {
  EXPECT_EQ(InterfaceIn(R"(<BehaviorTree ID="T"><SubTree ID="In" a="{outer}"/></BehaviorTree>
                           <BehaviorTree ID="In"><Follow driven="{a}"/></BehaviorTree>)",
                        "T"),
            "output outer double");
}

TEST(TreeInterface, AutoremapHandsOnEverythingElse) {
  EXPECT_EQ(InterfaceIn(R"(<BehaviorTree ID="T"><SubTree ID="In" _autoremap="true" goal="3"/>
                           </BehaviorTree>
                           <BehaviorTree ID="In"><Sequence><Plan to="{goal}"/><Plan to="{next}"/>
                           </Sequence></BehaviorTree>)",
                        "T"),
            "input next Pose2D");
}

TEST(TreeInterface, DeclaredPortsComeFirst) {
  EXPECT_EQ(InterfaceIn(R"(<BehaviorTree ID="T"><Plan to="{goal}" path="{p}"/></BehaviorTree>
                           <TreeNodesModel><SubTree ID="T"><output_port name="p" type="Path"/>
                           </SubTree></TreeNodesModel>)",
                        "T"),
            "output p Path!, input goal Pose2D");
}

TEST(TreeInterface, WhatAUserOfTheTreeNamesIsShared) {
  EXPECT_EQ(InterfaceIn(R"(<BehaviorTree ID="T"><Sequence><Plan path="{p}"/><Follow path="{p}"/>
                           </Sequence></BehaviorTree>
                           <BehaviorTree ID="Main"><SubTree ID="T" p="{x}"/></BehaviorTree>)",
                        "T"),
            "inout p");
}

TEST(TreeInterface, TreesInEachOtherEnd) {
  EXPECT_EQ(InterfaceIn(R"(<BehaviorTree ID="T"><SubTree ID="T" a="{a}"/></BehaviorTree>)", "T"),
            "input a");
}

}  // namespace
}  // namespace coppice::editor
