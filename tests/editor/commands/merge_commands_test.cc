#include "editor/commands/merge_commands.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <set>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr char kFile[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence name="round">
      <Go  to="door"   speed="1"/> <!-- slowly -->
      <Say text="hello"/>
      <Wait msec="5"/>
    </Sequence>
  </BehaviorTree>
</root>
)";

std::string With(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

class MergeCommandsTest : public testing::Test {
 protected:
  MergeCommandsTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
  }

  EditorState& state() { return driver_.editor.state(); }
  OpenProject& project() { return state().workspace.project(); }
  const EditedFile& File() { return *project().Find(file_.path()); }
  const std::string& Text() { return File().text; }

  void IWrite(const std::string& text) { project().SetText(file_.path(), "Type", text); }
  void TheyWrite(const std::string& text) {
    file_.Write(text);
    // A file that is written twice in one tick of the disk's clock has the same stamp.
    std::filesystem::last_write_time(file_.path(), stamp_ += std::chrono::seconds(1));
    project().LookAtDisk();
  }
  void Ask() { state().commands.Run("file.resolve"); }
  std::vector<Choice> Rows() { return state().popup.prompt.preview(""); }
  std::string Answer() { return state().popup.prompt.run("").problem(); }

  TemporaryFile file_{"main.xml", kFile};
  std::filesystem::file_time_type stamp_ = std::filesystem::last_write_time(file_.path());
  Driver driver_;
};

TEST_F(MergeCommandsTest, WithoutADisputeThereIsNothingToAsk) {
  EXPECT_EQ(DisputedFile(state()), "");
  Ask();
  EXPECT_EQ(state().popup.kind, Popup::kNone);
  EXPECT_THAT(state().notice.text, HasSubstr("nobody else"));
  IWrite(With(kFile, "hello", "good evening"));
  TheyWrite(With(kFile, "door", "hall"));
  EXPECT_EQ(DisputedFile(state()), "") << "the changes do not meet";
  EXPECT_EQ(Text(), With(With(kFile, "hello", "good evening"), "door", "hall"));
}

TEST_F(MergeCommandsTest, OneAttributeThatBothChangedIsOnePlace) {
  const std::string mine = With(With(kFile, R"(speed="1")", R"(speed="2")"), "hello", "hi");
  const std::string theirs = With(With(kFile, R"(speed="1")", R"(speed="3")"), "door", "hall");
  IWrite(mine);
  TheyWrite(theirs);
  EXPECT_EQ(DisputedFile(state()), file_.path());
  EXPECT_EQ(Text(), mine) << "nothing changes before the user has answered";
  Ask();
  ASSERT_EQ(state().popup.kind, Popup::kPrompt);
  EXPECT_THAT(state().popup.prompt.hint, HasSubstr("main.xml"));
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_EQ(Rows()[0].kind, "mine");
  EXPECT_THAT(Rows()[0].title, HasSubstr(R"(speed="2")"));
  EXPECT_THAT(Rows()[0].note, HasSubstr(R"(theirs goes: speed="3")"));
  Rows()[0].run();
  EXPECT_EQ(Rows()[0].kind, "theirs");
  EXPECT_THAT(Rows()[0].title, HasSubstr(R"(speed="3")"));
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(),
            With(With(With(kFile, R"(speed="1")", R"(speed="3")"), "hello", "hi"), "door", "hall"));
  EXPECT_EQ(DisputedFile(state()), "");
}

TEST_F(MergeCommandsTest, UndoBringsBackEveryByteOfMine) {
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  TheyWrite(With(With(kFile, "hello", "two"), R"(msec="5")", "msec='6'"));
  Ask();
  EXPECT_EQ(Answer(), "");
  const std::string merged = With(mine, R"(msec="5")", "msec='6'");
  EXPECT_EQ(Text(), merged);
  ASSERT_NE(project().Undo(), nullptr);
  EXPECT_EQ(Text(), mine);
  ASSERT_NE(project().Undo(), nullptr);
  EXPECT_EQ(Text(), kFile);
  ASSERT_NE(project().Redo(), nullptr);
  ASSERT_NE(project().Redo(), nullptr);
  EXPECT_EQ(Text(), merged);
}

TEST_F(MergeCommandsTest, WhatIsMergedIsNewToTheDiskAndIsSavedWithoutAnotherQuestion) {
  IWrite(With(kFile, "hello", "one"));
  TheyWrite(With(kFile, "hello", "two"));
  Diagnostics diagnostics;
  EXPECT_FALSE(project().Save(file_.path(), diagnostics)) << "not before the user has answered";
  Ask();
  EXPECT_EQ(Answer(), "");
  EXPECT_TRUE(File().is_dirty());
  EXPECT_TRUE(project().Save(file_.path(), diagnostics));
  std::ifstream stream(file_.path(), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(stream), {}), With(kFile, "hello", "one"));
}

TEST_F(MergeCommandsTest, WhoGivesUpHalfWayHasDecidedNothing) {
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  TheyWrite(With(kFile, "hello", "two"));
  Ask();
  Rows()[0].run();
  driver_.Press(kKeyEscape);
  driver_.Frames();
  EXPECT_EQ(state().popup.kind, Popup::kNone);
  EXPECT_EQ(Text(), mine);
  EXPECT_EQ(DisputedFile(state()), file_.path()) << "the question stays";
  Ask();
  EXPECT_EQ(Rows()[0].kind, "mine");
}

TEST_F(MergeCommandsTest, ANodeThatIsGoneThereAndChangedHereIsAPlace) {
  IWrite(With(kFile, "hello", "good evening"));
  TheyWrite(With(kFile, "\n      <Say text=\"hello\"/>", ""));
  Ask();
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_THAT(Rows()[0].title, HasSubstr(R"(<Say text="good evening")"));
  EXPECT_THAT(Rows()[0].note, HasSubstr("(nothing)"));
  EXPECT_EQ(Answer(), "") << "mine stays";
  EXPECT_EQ(Text(), With(kFile, "hello", "good evening"));
}

TEST_F(MergeCommandsTest, ANodeThatIsGoneHereAndChangedThereCanBeTakenBack) {
  IWrite(With(kFile, "\n      <Say text=\"hello\"/>", ""));
  const std::string theirs = With(kFile, "hello", "good evening");
  TheyWrite(theirs);
  Ask();
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_EQ(Rows()[0].title, "(nothing)");
  Rows()[0].run();
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(), theirs);
}

TEST_F(MergeCommandsTest, ANodeThatOneMovedAndTheOtherChangedIsAPlace) {
  const std::string wait = "\n      <Wait msec=\"5\"/>";
  const std::string go = "\n      <Go ";
  IWrite(With(With(kFile, wait, ""), go, wait + go));
  TheyWrite(With(kFile, R"(msec="5")", R"(msec="9")"));
  Ask();
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(), With(With(kFile, wait, ""), go, wait + go)) << "mine: moved, as it was";
  project().Undo();
  EXPECT_EQ(Text(), kFile) << "who keeps all of his has not changed anything";
}

TEST_F(MergeCommandsTest, ChildrenThatBothOrderedAnewStandAsOneOfThemSays) {
  const std::string say = R"(<Say text="hello"/>)";
  const std::string wait = R"(<Wait msec="5"/>)";
  const auto reordered = [&](const std::string& first, const std::string& second) {
    std::string text = With(kFile, say, "@1");
    text = With(text, wait, "@2");
    return With(With(text, "@1", first), "@2", second);
  };
  const std::string mine = reordered(wait, say);
  const std::string theirs = reordered(wait, R"(<Say text="bye"/>)");
  IWrite(mine);
  TheyWrite(theirs);
  Ask();
  for (Choice& row : Rows()) row.run();
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(), theirs);
}

TEST_F(MergeCommandsTest, ChildrenThatBothAddedInOnePlaceAreAChoice) {
  const std::string end = "\n    </Sequence>";
  const std::string mine = With(kFile, end, "\n      <Mine/>" + end);
  const std::string theirs = With(kFile, end, "\n      <Theirs/>" + end);
  IWrite(mine);
  TheyWrite(theirs);
  Ask();
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_EQ(Rows()[0].title, "<Mine/>") << Rows()[0].title;
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(), mine);
}

TEST_F(MergeCommandsTest, WhatWouldBeMalformedIsRefusedAndNothingHasChanged) {
  const std::string mine =
      With(With(kFile, "<Say", "<Inverter><Say"), R"("hello"/>)", R"("hello"/></Inverter>)");
  const std::string theirs = With(With(kFile, "<Say", R"(<Repeat num_cycles="2"><Say)"),
                                  R"("hello"/>)", R"("hello"/></Repeat>)");
  IWrite(mine);
  TheyWrite(theirs);
  Ask();
  const std::size_t places = Rows().size();
  ASSERT_GT(places, 1U) << "the opening and the closing tag";
  Rows()[0].run();
  EXPECT_THAT(Answer(), HasSubstr("malformed XML"));
  EXPECT_EQ(Text(), mine);
  EXPECT_EQ(DisputedFile(state()), file_.path());
  for (std::size_t i = 1; i < places; ++i) Rows()[i].run();
  EXPECT_EQ(Answer(), "") << "all of theirs";
  EXPECT_EQ(Text(), theirs);
}

TEST_F(MergeCommandsTest, WhatIsWrittenWhileTheUserDecidesIsAskedAnew) {
  IWrite(With(kFile, "hello", "one"));
  TheyWrite(With(kFile, "hello", "two"));
  Ask();
  Rows()[0].run();
  TheyWrite(With(With(kFile, "hello", "three"), "door", "hall"));
  EXPECT_THAT(Answer(), HasSubstr("changed again"));
  EXPECT_EQ(Text(), With(kFile, "hello", "one"));
  ASSERT_EQ(Rows().size(), 1U);
  EXPECT_EQ(Rows()[0].kind, "mine") << "nothing is decided about the new words";
  EXPECT_THAT(Rows()[0].note, HasSubstr("three"));
  EXPECT_EQ(Answer(), "");
  EXPECT_EQ(Text(), With(With(kFile, "hello", "one"), "door", "hall"));
}

TEST_F(MergeCommandsTest, WhatSettlesItselfWhileTheUserDecidesIsSaid) {
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  TheyWrite(With(kFile, "hello", "two"));
  Ask();
  TheyWrite(mine);
  EXPECT_EQ(DisputedFile(state()), "") << "both have written the same";
  EXPECT_FALSE(File().is_dirty());
  EXPECT_EQ(Answer(), "");
  EXPECT_THAT(state().notice.text, HasSubstr("settled already"));
  EXPECT_EQ(Text(), mine);
}

TEST_F(MergeCommandsTest, WhatTheyTakeBackIsNoDisputeAnyMore) {
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  TheyWrite(With(kFile, "hello", "two"));
  TheyWrite(kFile);
  EXPECT_EQ(DisputedFile(state()), "");
  EXPECT_EQ(Text(), mine);
  EXPECT_TRUE(File().is_dirty());
}

TEST_F(MergeCommandsTest, AFileThatTheyEmptiedIsAPlaceAsWell) {
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  TheyWrite("");
  EXPECT_EQ(DisputedFile(state()), file_.path());
  Ask();
  ASSERT_FALSE(Rows().empty());
  EXPECT_EQ(Answer(), "") << "mine";
  EXPECT_THAT(Text(), HasSubstr(R"(text="one")"));
}

TEST_F(MergeCommandsTest, OfSeveralFilesOneIsAskedAfterTheOther) {
  const TemporaryFile other("other.xml", kFile);
  driver_.editor.Open(other.path());
  driver_.Frames();
  const std::string mine = With(kFile, "hello", "one");
  IWrite(mine);
  project().SetText(other.path(), "Type", mine);
  other.Write(With(kFile, "hello", "zwei"));
  std::filesystem::last_write_time(other.path(), stamp_ + std::chrono::seconds(9));
  TheyWrite(With(kFile, "hello", "two"));
  std::set<std::string> asked;
  for (int i = 0; i < 2; ++i) {
    asked.insert(DisputedFile(state()));
    Ask();
    EXPECT_EQ(Answer(), "");
  }
  EXPECT_EQ(asked, (std::set<std::string>{file_.path(), other.path()}));
  EXPECT_EQ(DisputedFile(state()), "");
}

}  // namespace
}  // namespace coppice::editor
