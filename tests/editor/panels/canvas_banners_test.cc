#include "editor/panels/canvas_banners.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kTwice[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence><SubTree ID="Walk"/><SubTree ID="Walk"/><SubTree ID="Sit"/></Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Walk"><AlwaysSuccess/></BehaviorTree>
  <BehaviorTree ID="Sit"><AlwaysSuccess/></BehaviorTree>
</root>
)";

class CanvasBannersTest : public testing::Test {
 protected:
  void Show(const std::string& text) {
    file_.Write(text);
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }
  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }

  TemporaryFile file_{"twice.xml", ""};
  Driver driver_;
};

TEST_F(CanvasBannersTest, TellThatATreeIsUsedInSeveralPlaces) {
  Show(kTwice);
  EXPECT_FALSE(driver_.Has("banner/shared"));
  driver_.view().Select(driver_.view().scene()->FindPath("1.1"));
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("banner/shared")) << "the SubTree itself belongs to Main";
  driver_.view().Select(driver_.view().scene()->FindPath("1.1.1"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("banner/shared"));
  driver_.Picture("shared_tree");
  driver_.view().Select(driver_.view().scene()->FindPath("1.3.1"));
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("banner/shared")) << "one place";
}

// A tree that was fitted into a canvas as high as it.
TEST_F(CanvasBannersTest, CutNothingOfATreeThatWasFitted) {
  driver_.input.height = 480;
  Show(kSmallFile);
  driver_.Press(kKeyHome);
  driver_.Frames(12);
  const auto on_screen = [&](const char* path) {
    return driver_.BoxOf(std::string("canvas/MainTree/") + path);
  };
  const char* const all[] = {"1", "1.1.1.1", "1.2.1.1", "1.3"};
  const float before = on_screen("1").center().y;
  std::string broken = kSmallFile;
  broken.erase(broken.find("</Fallback>"), 11);
  file_.Write(broken);
  driver_.Frames(60);
  ASSERT_TRUE(driver_.Has("banner/stale"));
  const Box canvas = driver_.BoxOf("canvas");
  for (const char* path : all) {
    EXPECT_TRUE(canvas.Contains(on_screen(path).min)) << path;
    EXPECT_TRUE(canvas.Contains(on_screen(path).max)) << path;
  }
  EXPECT_NEAR(on_screen("1").center().y, before, 16) << "it hardly moves";
}

TEST_F(CanvasBannersTest, LeaveTheNodeUnderTheMouseWhereItIs) {
  Show(kTwice);
  const Box before = driver_.BoxOf("canvas/Main/1.1.1");
  driver_.ClickAt(before.center());
  driver_.Frames();
  ASSERT_TRUE(driver_.Has("banner/shared"));
  EXPECT_NEAR(driver_.BoxOf("canvas/Main/1.1.1").min.y, before.min.y, 1)
      << "else a double click would miss it";
}

TEST_F(CanvasBannersTest, ListThePlaces) {
  Show(kTwice);
  driver_.view().Select(driver_.view().scene()->FindPath("1.2.1"));
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("banner/uses"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("popup/1"));
  EXPECT_FALSE(driver_.Has("popup/2"));
}

TEST_F(CanvasBannersTest, AskWhoseStaysWhenBothHaveChangedTheSamePlace) {
  Show(kSmallFile);
  driver_.view().Select(driver_.view().scene()->FindPath("1.1.2"));
  driver_.editor.state().commands.Run("edit.disable");
  driver_.Frames();
  std::string other = kSmallFile;
  other.replace(other.find(R"(level="{level}"/>)"), 17, R"(level="{level}" _skipIf="late"/>)");
  file_.Write(other);
  driver_.Frames(60);
  ASSERT_TRUE(driver_.Has("banner/dispute"));
  ASSERT_TRUE(driver_.Click("banner/resolve"));
  driver_.Frames();
  ASSERT_TRUE(driver_.Has("popup/0"));
  driver_.Picture("resolve");
  ASSERT_TRUE(driver_.Click("popup/0")) << "theirs";
  driver_.Press(kKeyEnter);
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("banner/dispute"));
  EXPECT_EQ(Text(), other);
  driver_.Press('Z', kCtrl);
  EXPECT_NE(Text().find(R"(_skipIf="true")"), std::string::npos) << "a step like any other";
}

TEST_F(CanvasBannersTest, MineStaysIfNothingElseIsSaid) {
  Show(kSmallFile);
  driver_.view().Select(driver_.view().scene()->FindPath("1.3"));
  driver_.editor.state().commands.Run("edit.disable");
  driver_.Frames();
  std::string other = kSmallFile;
  other.replace(other.find("<AlwaysSuccess/>"), 16, R"(<AlwaysSuccess _skipIf="late"/>)");
  other.replace(other.find(R"(lamp="hall")"), 11, R"(lamp="attic")");
  file_.Write(other);
  driver_.Frames(60);
  driver_.editor.state().commands.Run("file.resolve");
  driver_.Frames();
  driver_.Press(kKeyEnter);
  EXPECT_NE(Text().find(R"(_skipIf="true")"), std::string::npos);
  EXPECT_NE(Text().find(R"(lamp="attic")"), std::string::npos) << "what does not meet is merged";
}

TEST_F(CanvasBannersTest, OfferUnsavedWorkOfTheLastTime) {
  EditorOptions options;
  options.backup_folder = file_.folder() + "/backup";
  file_.Write(kSmallFile);
  {
    Driver before(options);
    before.editor.Open(file_.path());
    before.Frames();
    before.view().Select(before.view().scene()->FindPath("1.3"));
    before.editor.state().commands.Run("edit.disable");
    before.Frames(300);
  }
  Driver after(options);
  after.editor.Open(file_.path());
  after.Frames();
  ASSERT_TRUE(after.Has("banner/unsaved"));
  ASSERT_TRUE(after.Click("banner/restore"));
  EXPECT_FALSE(after.Has("banner/unsaved"));
  EXPECT_NE(after.editor.state().workspace.project().Find(file_.path())->text.find("_skipIf"),
            std::string::npos);
}

TEST_F(CanvasBannersTest, TellThatTheTreeIsOlderThanItsText) {
  Show(kSmallFile);
  EXPECT_FALSE(driver_.Has("banner/stale"));
  std::string text = kSmallFile;
  text.replace(text.find("</Sequence>"), 11, "</Sequenz>");
  driver_.editor.state().workspace.project().SetText(file_.path(), "Type", text);
  driver_.editor.state().workspace.Refresh(driver_.editor.now());
  driver_.Frames(20);
  EXPECT_TRUE(driver_.Has("banner/stale"));
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1"));
}

}  // namespace
}  // namespace coppice::editor
