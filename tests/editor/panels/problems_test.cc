#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Problems, LeadToTheNode) {
  const TemporaryFile file("wrong.xml",
                           "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"A\"><AlwaysSuccess/>"
                           "</BehaviorTree>\n<BehaviorTree ID=\"B\">\n<Sequence>\n"
                           R"(<RetryUntilSuccessful num_attempts="many"><Go/>)"
                           "</RetryUntilSuccessful>\n</Sequence>\n</BehaviorTree></root>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const auto& problems = driver.editor.state().workspace.files()[0].problems;
  ASSERT_FALSE(problems.empty());
  std::size_t wanted = 0;
  while (wanted < problems.size() && problems[wanted].where.line != 5) ++wanted;
  ASSERT_LT(wanted, problems.size()) << ToString(problems[0]);
  ASSERT_TRUE(driver.Click("problems/" + std::to_string(wanted)));
  EXPECT_EQ(driver.view().scene()->tree_id, "B");
  EXPECT_EQ(driver.Selected(), "1.1");
}

TEST(Problems, ErrorsComeFirst) {
  const TemporaryFile file(
      "wrong.xml",
      "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"A\"><Sequence>\n"
      "<SubTree ID=\"Gone\"/>\n<Inverter/>\n</Sequence></BehaviorTree></root>");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const auto& problems = driver.editor.state().workspace.files()[0].problems;
  ASSERT_EQ(problems.size(), 2U);
  ASSERT_EQ(problems[0].severity, Severity::kWarning) << "as it comes in the file";
  ASSERT_TRUE(driver.Click("problems/0"));
  EXPECT_EQ(driver.Selected(), "1.2");
}

constexpr char kFormat3[] =
    "<root main_tree_to_execute=\"A\">\n<BehaviorTree ID=\"A\">\n<Sequence>\n"
    R"(<BlackboardCheckInt value_A="{n}" value_B="3" return_on_mismatch="FAILURE">)"
    "<AlwaysSuccess/></BlackboardCheckInt>\n<AlwaysFailure/>\n</Sequence>\n</BehaviorTree></root>";

// A check of the blackboard is two nodes of format 4, so its tree has none of the file's elements.
TEST(Problems, MakeAFileOfFormat3OneOfFormat4) {
  const TemporaryFile file("old.xml", kFormat3);
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  driver.view().Select(driver.view().scene()->FindPath("1.2"));
  driver.Press(kKeyDelete);
  EXPECT_NE(driver.editor.state().notice.text.find("make it format 4"), std::string::npos)
      << driver.editor.state().notice.text;
  const auto text = [&] {
    return driver.editor.state().workspace.project().Find(file.path())->text;
  };
  EXPECT_EQ(text(), kFormat3);
  ASSERT_TRUE(driver.Click("problems/0/fix/0"));
  driver.Frames();
  EXPECT_NE(text().find("BTCPP_format=\"4\""), std::string::npos);
  EXPECT_NE(text().find("ScriptCondition"), std::string::npos);
  driver.view().Select(driver.view().scene()->FindPath("1.2"));
  driver.Press(kKeyDelete);
  EXPECT_EQ(text().find("AlwaysFailure"), std::string::npos);
  driver.Press('Z', kCtrl);
  driver.Press('Z', kCtrl);
  EXPECT_EQ(text(), kFormat3);
}

TEST(Problems, TellWhyARobotIsNotConnected) {
  Driver driver;
  ScriptedRobot* const robot = driver.AddRobot("robot:1", kLiveTree);
  EXPECT_FALSE(driver.Has("run/problem"));
  robot->Disconnect("no answer");
  driver.Frames();
  EXPECT_TRUE(driver.Has("run/problem")) << "beside what is known of the run";
}

TEST(Problems, ALongMessageHasALineForItsPlaceAndItsButtons) {
  const TemporaryFile file("wrong.xml",
                           "<root BTCPP_format=\"4\"><BehaviorTree ID=\"A\"><Sequence>\n<Inverter/>"
                           "\n<SubTree ID=\"Wlak\"/>\n</Sequence></BehaviorTree>\n<BehaviorTree "
                           R"(ID="Walk"><AlwaysSuccess/></BehaviorTree></root>)");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  driver.OpenRow();
  const std::string walk = driver.Has("problems/0/fix/0") ? "problems/0" : "problems/1";
  ASSERT_TRUE(driver.Has(walk + "/fix/0"));
  const Box row = driver.BoxOf(walk);
  EXPECT_GE(driver.BoxOf(walk + "/fix/0").min.y, row.center().y - 1) << "below the message";
  ASSERT_TRUE(driver.Click(walk + "/fix/0"));
  EXPECT_NE(driver.editor.state().workspace.project().Find(file.path())->text.find(R"(ID="Walk"/)"),
            std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
