#include "editor/commands/picture_commands.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class PictureCommandsTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(driver_.editor.Open(file_.path()));
    driver_.Frames();
  }
  void Answer(const std::string& text) {
    driver_.editor.state().popup.text = text;
    driver_.Frames();
    driver_.Press(kKeyEnter);
  }

  const TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(PictureCommandsTest, ExportsTheShownTreeBesideItsFile) {
  driver_.editor.state().commands.Run("file.export");
  driver_.Frames();
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kOpen) << "with the folder, as for files";
  EXPECT_EQ(driver_.editor.state().popup.text, "MainTree.svg");
  driver_.Press(kKeyEnter);
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kNone);
  EXPECT_NE(ReadFile(file_.folder() + "/MainTree.svg").find(">round</text>"), std::string::npos);
}

TEST_F(PictureCommandsTest, APictureIsReplacedOnlyIfThatIsSaidTwice) {
  const std::string path = file_.folder() + "/MainTree.svg";
  std::ofstream(path) << "mine";
  driver_.editor.state().commands.Run("file.export");
  driver_.Frames();
  driver_.Press(kKeyEnter);
  EXPECT_EQ(ReadFile(path), "mine");
  EXPECT_NE(driver_.editor.state().popup.error.find("once more"), std::string::npos);
  driver_.Press(kKeyEnter);
  EXPECT_NE(ReadFile(path), "mine");
}

TEST_F(PictureCommandsTest, SaysWhyAPictureCannotBeWrittenAndAsksAgain) {
  driver_.editor.state().commands.Run("file.export");
  Answer("/nowhere/t.svg");
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kOpen);
  EXPECT_NE(driver_.editor.state().popup.error.find("/nowhere"), std::string::npos)
      << driver_.editor.state().popup.error;
}

TEST_F(PictureCommandsTest, ComparesWithWhatWasSavedLast) {
  driver_.Click("canvas/MainTree/1.3");
  driver_.editor.state().commands.Run("edit.delete");
  driver_.Frames();
  driver_.editor.state().commands.Run("file.compare");
  Answer("");
  driver_.Frames();
  ASSERT_TRUE(driver_.editor.state().canvas.comparison);
  EXPECT_EQ(driver_.editor.state().canvas.comparison->summary(), "1 removed");
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1.3")) << "what was removed is shown";
  EXPECT_TRUE(driver_.Click("comparison/close"));
  EXPECT_FALSE(driver_.editor.state().canvas.comparison);
}

TEST_F(PictureCommandsTest, TheComparisonFollowsWhatIsEdited) {
  driver_.editor.state().commands.Run("file.compare");
  Answer(file_.path());
  driver_.Frames();
  ASSERT_TRUE(driver_.editor.state().canvas.comparison);
  EXPECT_EQ(driver_.editor.state().canvas.comparison->summary(), "no difference");
  driver_.view().Select(driver_.view().scene()->FindPath("1.3"));
  driver_.editor.state().commands.Run("edit.delete");
  driver_.Frames();
  EXPECT_EQ(driver_.editor.state().canvas.comparison->summary(), "1 removed");
  driver_.editor.state().commands.Run("file.stop_comparing");
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("comparison/close"));
}

TEST_F(PictureCommandsTest, AFileWithoutATreeIsRefused) {
  driver_.editor.state().commands.Run("file.compare");
  Answer("/nowhere.xml");
  EXPECT_FALSE(driver_.editor.state().canvas.comparison);
  EXPECT_NE(driver_.editor.state().popup.error, "");
}

}  // namespace
}  // namespace coppice::editor
