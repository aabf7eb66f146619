// What people do with a tree that is there already.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "editor/canvas/data_links.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

// As somebody wrote it: comments, two kinds of quotes, columns, attributes of other programs.
constexpr char kByHand[] = R"(<?xml version='1.0'?>
<!-- kept by the night shift -->
<root BTCPP_format="4" main_tree_to_execute="Main" editor:zoom='2'>

  <BehaviorTree ID="Main" note="x &lt; y">
    <Sequence   name='round' >
      <Say  text = "hello"    volume='3'/>   <!-- not too loud -->
      <Wait msec="5" />
      <Say text="bye" volume="3"/>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="Say">
      <input_port name="volume" type="int">0 to 9</input_port>
      <input_port name="text" type="string">what is said</input_port>
      <input_port name="slowly" type="bool" default="false">word by word</input_port>
    </Action>
    <Action ID="Shout"><input_port name="text" type="string"/></Action>
    <Action ID="Wait"><input_port name="msec" type="int"/></Action>
  </TreeNodesModel>
</root>
)";

class ExistingTreeStory : public testing::Test {
 protected:
  ExistingTreeStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }

  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  std::string Disk() const {
    std::ifstream stream(file_.path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  // The lines of the second that the first does not have.
  static int ChangedLines(const std::string& before, const std::string& after) {
    std::istringstream a(before);
    std::istringstream b(after);
    int changed = 0;
    for (std::string x, y; std::getline(b, y);) changed += !std::getline(a, x) || x != y;
    return changed;
  }
  void Select(const std::string& path) { ASSERT_TRUE(driver_.Click("canvas/Main/" + path)); }

  const TemporaryFile file_{"byhand.xml", kByHand};
  Driver driver_;
};

TEST_F(ExistingTreeStory, OneEditChangesOneLineOfTheFile) {
  Select("1.1");
  driver_.Press(kKeyF1 + 1);
  driver_.Type("greet");
  driver_.Press(kKeyEnter);
  driver_.Press('S', kCtrl);
  driver_.Frames();
  EXPECT_THAT(Disk(), HasSubstr("greet"));
  EXPECT_EQ(ChangedLines(kByHand, Disk()), 1);
}

TEST_F(ExistingTreeStory, SavingWithoutAChangeLeavesTheBytes) {
  driver_.Press('S', kCtrl);
  driver_.Frames();
  EXPECT_EQ(Disk(), kByHand);
}

TEST_F(ExistingTreeStory, AnotherTypeKeepsThePortsThatItKnows) {
  Select("1.1");
  driver_.Press('R');
  driver_.Type("Shout");
  driver_.Frames();
  driver_.Picture("story_change_type");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr("<Shout  text = \"hello\""));
}

TEST_F(ExistingTreeStory, SeveralNodesAreCopiedIntoATreeOfAnotherTab) {
  Select("1.1");
  driver_.Hold(kCtrl);
  Select("1.2");
  driver_.Hold(kNoModifier);
  driver_.Press('C', kCtrl);
  driver_.Press('T', kCtrl);
  driver_.Type("Second");
  driver_.Press(kKeyEnter);
  driver_.Frames();
  driver_.Press(kKeyTab);
  driver_.Type("Sequence");
  driver_.Press(kKeyEnter);
  driver_.Press('V', kCtrl);
  driver_.Frames();
  const std::string second = Text().substr(Text().find("ID=\"Second\""));
  EXPECT_THAT(second, HasSubstr("<Say  text = \"hello\""));
  EXPECT_THAT(second, HasSubstr("<Wait msec=\"5\""));
}

TEST_F(ExistingTreeStory, UndoInAFieldTakesBackWhatIsTypedAndNotTheTree) {
  Select("1.2");
  driver_.Press('D');
  ASSERT_THAT(Text(), HasSubstr("_skipIf"));
  Select("1.1");
  driver_.Press(kKeyF1 + 1);
  driver_.Type("greet");
  driver_.Press('Z', kCtrl);
  driver_.Frames();
  EXPECT_THAT(Text(), HasSubstr("_skipIf")) << "the tree stays";
  driver_.Press(kKeyEscape);
  driver_.Frames();
  driver_.Press('Z', kCtrl);
  EXPECT_EQ(Text(), kByHand);
}

TEST_F(ExistingTreeStory, PortsStandInTheOrderInWhichTheyAreDeclaredWithWhatTheyAre) {
  Select("1.1");
  driver_.Frames();
  const Box volume = driver_.BoxOf("inspector/port/volume");
  const Box text = driver_.BoxOf("inspector/port/text");
  const Box slowly = driver_.BoxOf("inspector/port/slowly");
  EXPECT_LT(volume.min.y, text.min.y) << "declared first, written second";
  EXPECT_LT(text.min.y, slowly.min.y) << "not given, offered";
  ASSERT_TRUE(driver_.Click("inspector/port/volume/more"));
  EXPECT_THAT(Text(), HasSubstr("volume='4'"));
  ASSERT_TRUE(driver_.Click("inspector/port/slowly/toggle"));
  EXPECT_THAT(Text(), HasSubstr("slowly='true'"));
}

TEST(LitKeyStory, AKeyThatIsClickedIsLitWhereverItIsUsedAndEscEndsIt) {
  const TemporaryFile file("keys.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
<Script code="speed := 2"/><Say text="{speed}"/><Wait msec="{other}"/>
</Sequence></BehaviorTree></root>)");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(8);
  const Box say = driver.BoxOf("canvas/Main/1.2");
  driver.ClickAt({say.max.x - 30, say.max.y - 10});
  driver.Frames(30);
  driver.Picture("story_key_is_lit");
  TreeView& view = driver.view();
  ASSERT_NE(view.lit_key(), kNoKey);
  EXPECT_TRUE(IsLit(view, 1)) << "the script that writes it";
  EXPECT_TRUE(IsLit(view, 2));
  EXPECT_FALSE(IsLit(view, 3));
  driver.Press(kKeyEscape);
  EXPECT_EQ(view.lit_key(), kNoKey);
}

}  // namespace
}  // namespace coppice::editor
