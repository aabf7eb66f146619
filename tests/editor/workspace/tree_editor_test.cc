#include "editor/workspace/tree_editor.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kFile[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence name="work">
      <Go name="there" to="{goal}"/>
      <Inverter name="not"><IsDark/></Inverter>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Empty"/>
  <TreeNodesModel>
    <Action ID="Go"><input_port name="to"/></Action><Action ID="Say"/><Condition ID="IsDark"/>
  </TreeNodesModel>
</root>
)";

class TreeEditorTest : public testing::Test {
 protected:
  TreeEditorTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }
  EditorState& state() { return driver_.editor.state(); }
  TreeEditor Edit() { return {state(), 0}; }
  const std::string& Text() { return state().workspace.project().Find(file_.path())->text; }
  void Select(const std::string& path) {
    driver_.view().Select(driver_.view().scene()->FindPath(path));
  }

  TemporaryFile file_{"main.xml", kFile};
  Driver driver_;
};

TEST_F(TreeEditorTest, SaysWhereANewNodeWouldGoAndPutsItThere) {
  Select("1");
  EXPECT_EQ(Edit().PlaceOfNew(), "into \"work\"");
  Select("1.1");
  EXPECT_EQ(Edit().PlaceOfNew(), "after \"there\"");
  EXPECT_TRUE(Edit().Add("<Say/>", "Say", AddWhere::kChild)) << "a leaf gets a sibling";
  EXPECT_THAT(Text(), HasSubstr("<Go name=\"there\" to=\"{goal}\"/>\n      <Say/>"));
  EXPECT_EQ(driver_.Selected(), "1.2");
  Select("1.1");
  EXPECT_TRUE(Edit().Add("<Retry/>", "Retry", AddWhere::kAround));
  EXPECT_THAT(Text(), HasSubstr("<Retry>"));
  Edit().Undo();
  EXPECT_THAT(Text(), Not(HasSubstr("<Retry>")));
}

TEST_F(TreeEditorTest, AnEmptyTreeGetsItsRoot) {
  state().workspace.ShowFileTree(0, 1, 0);
  EXPECT_EQ(Edit().PlaceOfNew(), "as the root of \"Empty\"");
  EXPECT_TRUE(Edit().Add("<Say/>", "Say", AddWhere::kChild));
  EXPECT_THAT(Text(), HasSubstr(R"(<BehaviorTree ID="Empty">)"));
}

TEST_F(TreeEditorTest, RefusalsChangeNothingAndSayWhy) {
  const std::string before = Text();
  Select("1.2");
  EXPECT_FALSE(Edit().Add("<Say/>", "Say", AddWhere::kChild)) << "a decorator has one child";
  EXPECT_TRUE(state().notice.is_refusal);
  Select("1.1");
  Edit().Demote();
  EXPECT_TRUE(state().notice.is_refusal);
  driver_.view().Select(kNoSceneNode);
  Edit().Delete();
  EXPECT_TRUE(state().notice.is_refusal);
  EXPECT_EQ(Text(), before);
}

TEST_F(TreeEditorTest, ValuesAndNamesAreSetAndCleared) {
  Select("1.1");
  EXPECT_EQ(Edit().GivenName(), "there");
  EXPECT_TRUE(Edit().SetValue("to", "kitchen"));
  EXPECT_THAT(Text(), HasSubstr(R"(to="kitchen")"));
  EXPECT_TRUE(Edit().ClearValue("to"));
  EXPECT_THAT(Text(), Not(HasSubstr("to=")));
  EXPECT_TRUE(Edit().Rename("here"));
  EXPECT_EQ(Edit().GivenName(), "here");
  Edit().Undo();
  Edit().Undo();
  Edit().Undo();
  EXPECT_EQ(Text(), kFile);
  Edit().Redo();
  EXPECT_THAT(Text(), HasSubstr(R"(to="kitchen")"));
}

TEST_F(TreeEditorTest, DeletingADecoratorAloneKeepsItsChild) {
  Select("1.2");
  Edit().DeleteKeepingChildren();
  EXPECT_THAT(Text(), HasSubstr("<IsDark/>"));
  EXPECT_THAT(Text(), Not(HasSubstr("Inverter")));
  Edit().Undo();
  Select("1.2");
  Edit().Delete();
  EXPECT_THAT(Text(), Not(HasSubstr("<IsDark/>")));
}

TEST_F(TreeEditorTest, APasteWithErrorsPastesNothing) {
  Select("1");
  Edit().Paste("<Say", AddWhere::kChild);
  EXPECT_EQ(Text(), kFile);
  EXPECT_EQ(state().popup.kind, Popup::kPasteErrors);
  EXPECT_FALSE(state().popup.problems.empty());
}

TEST_F(TreeEditorTest, WhatWasCopiedIsXmlText) {
  std::string clipboard;
  state().services.set_clipboard = [&](const std::string& text) { clipboard = text; };
  Select("1.1");
  Edit().Cut();
  EXPECT_EQ(clipboard, "<Go name=\"there\" to=\"{goal}\"/>\n");
  EXPECT_THAT(Text(), Not(HasSubstr("there")));
  Select("1");
  Edit().Paste(clipboard, AddWhere::kChild);
  EXPECT_THAT(Text(), HasSubstr(R"(<Go name="there" to="{goal}"/>)"));
}

}  // namespace
}  // namespace coppice::editor
