#include "editor/panels/start_screen.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(StartScreen, OffersToOpenAndToConnect) {
  Driver driver;
  driver.Frames();
  ASSERT_TRUE(driver.Click("start/open"));
  EXPECT_EQ(driver.editor.state().popup.kind, Popup::kOpen);
  driver.Press(kKeyEscape);
  ASSERT_TRUE(driver.Click("start/connect"));
  EXPECT_EQ(driver.editor.state().popup.kind, Popup::kConnect);
}

TEST(StartScreen, OpensARecentFileWithAClick) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.state().recent.files = {file.path()};
  driver.Frames();
  ASSERT_TRUE(driver.Click("start/recent/0"));
  driver.Frames();
  EXPECT_EQ(driver.editor.state().workspace.ShownTreeId(), "MainTree");
  EXPECT_FALSE(driver.Has("start/open"));
}

TEST(StartScreen, OffersNothingWhereAFileHasNoTree) {
  const TemporaryFile file("none.xml", R"(<root BTCPP_format="4"/>)");
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames();
  EXPECT_FALSE(driver.Has("start/open"));
}

}  // namespace
}  // namespace coppice::editor
