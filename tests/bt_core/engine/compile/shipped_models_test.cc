#include "bt_core/engine/compile/shipped_models.h"

#include <gmock/gmock.h>

#include "bt_core/engine/compile/check_project.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using testing::HasSubstr;

std::string Check(const std::string& nodes) {
  Diagnostics diagnostics;
  auto project = Project::FromText("<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><Sequence>\n" +
                                       nodes + "</Sequence></BehaviorTree></root>",
                                   "t.xml", diagnostics);
  CheckProject(std::make_shared<const Project>(*std::move(project)), TestRegistry(), {},
               diagnostics);
  return diagnostics.ToString();
}

TEST(ShippedModels, AreWellFormedAndDescribeTheirNodes) {
  ASSERT_EQ(AllShippedModels().size(), 2U);
  for (const ShippedModels& set : AllShippedModels()) {
    EXPECT_GT(set.models.models().size(), 80U) << set.name;
    EXPECT_FALSE(set.models.has_errors()) << set.name;
  }
}

TEST(ShippedModels, TreesOfAWellKnownProgramAreChecked) {
  EXPECT_EQ(Check(R"(<ComputePathToPose goal="{g}" path="{p}"/><FollowPath path="{p}"/>)"), "");
  EXPECT_THAT(Check(R"(<BackUp backup_dist="far"/><FollowPath path="{p}"/>)"),
              HasSubstr("error: \"far\" is not a value for port \"backup_dist\""));
}

TEST(ShippedModels, OneTypeOfThatNameIsNoProof) {
  EXPECT_THAT(Check("<FollowPath/>"), HasSubstr("node type \"FollowPath\" is not built in"));
}

TEST(ShippedModels, ATypeThatIsUsedInAnotherWayIsAWarningWithTheNearestName) {
  const std::string said =
      Check(R"(<FollowPath path="{p}"/><ClearEntireCostmap/><BackUp backup_dst="1"/>)");
  EXPECT_THAT(said, HasSubstr(R"(t.xml:2:54: warning: "BackUp" of Nav2 has no port "backup_dst" )"
                              R"((did you mean "backup_dist"?))"));
  EXPECT_EQ(said.find("error"), std::string::npos) << said;
}

TEST(ShippedModels, AnOutputWithoutAKeyIsAnotherUse) {
  EXPECT_THAT(Check(R"(<BackUp/><Spin/><ComputePathToPose path="${path}"/>)"),
              HasSubstr("warning: port \"path\" of Nav2's \"ComputePathToPose\" needs a key"));
}

TEST(ShippedModels, WhatSomebodyElseDescribesStaysTheirs) {
  const std::vector<ShippedTypes> found =
      FindShippedTypes({}, [](std::string_view) { return true; });
  EXPECT_TRUE(found.empty());
}

TEST(ShippedModels, PortsWithoutATypeAreNotCopiesOfEachOther) {
  EXPECT_EQ(Check(R"(<AveragePoseStamped num_samples="{n}" run_continuously="false"/>
                     <GetImage topic_name="a" message_out="{i}"/>
                     <Repeat num_cycles="{n}"><AlwaysSuccess/></Repeat>)"),
            "");
}

}  // namespace
}  // namespace coppice
