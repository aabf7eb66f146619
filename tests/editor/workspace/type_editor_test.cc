#include "editor/workspace/type_editor.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

PortModel Port(const std::string& name) {
  PortModel port;
  port.name = name;
  return port;
}

class TypeEditorTest : public testing::Test {
 protected:
  TypeEditorTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  TypeEditor Edit() { return TypeEditor(driver_.editor.state(), driver_.editor.now()); }
  std::string Text() { return Text(file_.path()); }
  std::string Text(const std::string& path) {
    return driver_.editor.state().workspace.project().Find(path)->text;
  }
  const NodeModel* Known(const std::string& type) {
    return driver_.editor.state().workspace.file()->models->Find(type);
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(TypeEditorTest, AnUnknownTypeIsDefinedAsItsNodesSuggest) {
  EXPECT_TRUE(Edit().Define("Step").ok());
  EXPECT_THAT(Text(), HasSubstr("    <Action ID=\"Step\">\n      <input_port name=\"to\"/>\n"));
  ASSERT_TRUE(Known("Step"));
  EXPECT_EQ(Known("Step")->ports.size(), 1U);
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(TypeEditorTest, WhatIsDefinedOrBuiltInIsNotDefinedAgain) {
  EXPECT_EQ(Edit().Define("IsDark").problem(), "IsDark is defined already");
  EXPECT_EQ(Edit().Define("Sequence").problem(), "Sequence is built in");
}

TEST_F(TypeEditorTest, ATreeIsDefinedByWhatItShares) {
  EXPECT_TRUE(Edit().Define("Walk").ok());
  EXPECT_THAT(Text(), HasSubstr("<SubTree ID=\"Walk\">\n      <input_port name=\"goal\"/>"));
}

TEST_F(TypeEditorTest, ARenamedPortIsRenamedInTheNodes) {
  PortModel port = *Known("SwitchOn")->FindPort("level");
  port.name = "strength";
  EXPECT_TRUE(Edit().ChangePort("SwitchOn", "level", port).ok());
  EXPECT_THAT(Text(), HasSubstr(R"(<SwitchOn lamp="hall" strength="{level}"/>)"));
  EXPECT_THAT(Text(), HasSubstr(R"(<input_port name="strength" type="int">0 to 9</input_port>)"));
}

TEST_F(TypeEditorTest, ARenamedPortOfATreeIsItsKeyToo) {
  ASSERT_TRUE(Edit().Define("Walk").ok());
  PortModel port = *Known("Walk")->FindPort("goal");
  port.name = "target";
  EXPECT_TRUE(Edit().ChangePort("Walk", "goal", port).ok());
  EXPECT_THAT(Text(), HasSubstr(R"(name="walk" target="{goal}"/>)"));
  EXPECT_THAT(Text(), HasSubstr(R"(<Step to="{target}"/>)"));
}

TEST_F(TypeEditorTest, APortHasANameOfItsOwn) {
  EXPECT_EQ(Edit().AddPort("IsDark", Port("light")).problem(), "IsDark has a port light already");
  EXPECT_EQ(Edit().AddPort("IsDark", Port("a b")).problem(), "a b cannot be the name of a port");
  EXPECT_EQ(Edit().AddPort("Nobody", Port("a")).problem(),
            "no file of this project defines Nobody");
  EXPECT_EQ(Edit().FreePortName("IsDark"), "port");
}

TEST_F(TypeEditorTest, KindDescriptionAndPortsAreWrittenIntoTheModel) {
  EXPECT_TRUE(Edit().SetKind("SwitchOn", NodeCategory::kCondition).ok());
  EXPECT_TRUE(Edit().Describe("SwitchOn", "Lights up.").ok());
  EXPECT_TRUE(Edit().RemovePort("SwitchOn", "lamp").ok());
  EXPECT_THAT(Text(), HasSubstr("<Condition ID=\"SwitchOn\">"));
  EXPECT_THAT(Text(), HasSubstr("description=\"Lights up.\""));
  EXPECT_THAT(Text(), Not(HasSubstr("which one")));
}

TEST_F(TypeEditorTest, ADefinitionMovesIntoAnotherFileOfTheProject) {
  ASSERT_EQ(
      ProjectEditor(driver_.editor.state(), driver_.editor.now()).Include("models.xml").problem(),
      "");
  const std::string models = file_.folder() + "/models.xml";
  EXPECT_TRUE(Edit().MoveTo("IsDark", models).ok());
  EXPECT_THAT(Text(), Not(HasSubstr("Condition ID=\"IsDark\"")));
  EXPECT_THAT(Text(models), HasSubstr("    <Condition ID=\"IsDark\">"));
  EXPECT_EQ(Edit().FileOf("IsDark"), models);
}

}  // namespace
}  // namespace coppice::editor
