#include <gtest/gtest.h>

#include "editor/commands/menus.h"
#include "editor/theme/fonts.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class ScaleStory : public testing::Test {
 protected:
  ScaleStory() {
    options_.settings_file = folder_.Path("settings.json");
    options_.settings = options_.kept_settings;
    Start();
  }
  void Start() {
    driver_ = std::make_unique<Driver>(options_);
    driver_->input.width = 1600;
    driver_->input.height = 1000;
    driver_->editor.Open(file_.path());
    driver_->Frames(20);
  }
  float TitleHeight() const { return driver_->BoxOf("menu/view").height(); }

  const TemporaryFolder folder_;
  TemporaryFile file_{"small.xml", kSmallFile};
  EditorOptions options_;
  std::unique_ptr<Driver> driver_;
};

TEST_F(ScaleStory, KeysMakeEverythingLargerAndSmaller) {
  const float before = TitleHeight();
  driver_->Press('=', kCtrl);
  EXPECT_NEAR(TitleHeight(), before * 1.25F, 1);
  driver_->Press('=', kCtrl);
  EXPECT_NEAR(TitleHeight(), before * 1.5F, 1);
  driver_->Picture("scale_150");
  driver_->Press('-', kCtrl);
  EXPECT_NEAR(TitleHeight(), before * 1.25F, 1);
  driver_->Press('0', kCtrl);
  EXPECT_NEAR(TitleHeight(), before, 1);
}

TEST_F(ScaleStory, TheViewMenuOffersScales) {
  const float before = TitleHeight();
  driver_->Click("menu/view");
  driver_->MoveTo(driver_->BoxOf("menu/view.scale").center());
  driver_->Frames(20);
  ASSERT_TRUE(driver_->Click("menu/scale.200"));
  driver_->Frames();
  EXPECT_NEAR(TitleHeight(), before * 2, 1);
  driver_->Click("menu/view");
  driver_->MoveTo(driver_->BoxOf("menu/view.scale").center());
  driver_->Frames(20);
  driver_->Picture("scale_200");
}

// Of a menu that is longer than the screen.
class LongMenuStory : public ScaleStory {
 protected:
  LongMenuStory() {
    for (int i = 0; i < 4; ++i) driver_->Press('=', kCtrl);
    driver_->input.height = 600;
    driver_->Frames(20);
    driver_->Click("menu/view");
    driver_->Frames(4);
    const std::vector<MenuItem> items = ItemsOf(driver_->editor.state(), "view");
    first_ = items.front().path;
    last_ = items.back().path;
  }
  bool Shows(const std::string& item) const {
    const Box box = driver_->BoxOf(item);
    return driver_->Has(item) && box.min.y >= 0 && box.max.y <= driver_->input.height;
  }
  std::string first_, last_;
};

TEST_F(LongMenuStory, KeysReachTheLastEntry) {
  ASSERT_TRUE(Shows(first_));
  ASSERT_FALSE(Shows(last_));
  driver_->Press(kKeyUp);
  driver_->Press(kKeyUp);
  driver_->Press(kKeyDown);
  driver_->Frames(10);
  EXPECT_TRUE(Shows(last_));
  EXPECT_FALSE(Shows(first_));
}

TEST_F(LongMenuStory, TheWheelReachesTheLastEntryAndTheMenuStaysThere) {
  ASSERT_FALSE(Shows(last_));
  driver_->MoveTo(driver_->BoxOf(first_).center());
  for (int i = 0; i < 40; ++i) driver_->Wheel(-1);
  driver_->Frames(10);
  EXPECT_TRUE(Shows(last_));
  driver_->Picture("long_menu");
}

TEST_F(LongMenuStory, TheScrollbarReachesTheLastEntryAndTheMenuStaysThere) {
  ASSERT_FALSE(Shows(last_));
  const Box menu = driver_->BoxOf("menu/window/0");
  const float across = menu.max.x - 5;
  driver_->Drag({across, menu.min.y + 20}, {across, menu.max.y - 2});
  driver_->Frames(10);
  EXPECT_TRUE(Shows(last_));
}

TEST_F(ScaleStory, IsThereAgainTheNextTime) {
  const float before = TitleHeight();
  driver_->Press('=', kCtrl);
  driver_.reset();
  Diagnostics diagnostics;
  options_.kept_settings = ReadSettings(ReadFile(options_.settings_file), "", diagnostics);
  options_.settings = options_.kept_settings;
  Start();
  EXPECT_NEAR(TitleHeight(), before * 1.25F, 1);
}

// What is painted twice as large has not half as much room for the tree.
TEST_F(ScaleStory, ATreeThatIsFittedStaysWhole) {
  driver_->Press('=', kCtrl);
  driver_->Press('=', kCtrl);
  driver_->Frames(20);
  const Box canvas = driver_->BoxOf("canvas");
  for (const char* node : {"1", "1.1.1.1", "1.2.1.1", "1.3"}) {
    const Box box = driver_->BoxOf(std::string("canvas/MainTree/") + node);
    EXPECT_TRUE(canvas.Contains(box.min) && canvas.Contains(box.max)) << node;
  }
}

TEST_F(ScaleStory, ATreeThatTheUserHasMovedGrowsWithTheRest) {
  driver_->MoveTo(driver_->BoxOf("canvas/MainTree/1.1").center());
  driver_->Zoom(1);
  const float zoom = driver_->view().camera.zoom;
  driver_->Press('=', kCtrl);
  driver_->Frames(20);
  EXPECT_NEAR(driver_->view().camera.zoom, zoom * 1.25F, 0.01F);
}

}  // namespace
}  // namespace coppice::editor
