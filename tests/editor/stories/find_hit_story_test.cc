#include <gtest/gtest.h>

#include "editor/canvas/layout/layout_choice.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// Far more than can be read at once.
std::string LargeTree() {
  std::string text = R"(<root BTCPP_format="4"><BehaviorTree ID="T"><Sequence name="top">)";
  for (int room = 0; room < 40; ++room) {
    text += "<Fallback name=\"room " + std::to_string(room) + "\">";
    for (int leaf = 0; leaf < 8; ++leaf) {
      text += "<Drive name=\"drive " + std::to_string(room * 8 + leaf) + "\" to=\"{goal}\"/>";
    }
    text += "</Fallback>";
  }
  return text + "</Sequence></BehaviorTree></root>";
}

TEST(FindHitStory, FindAndF3ComeSoCloseThatTheHitCanBeRead) {
  const TemporaryFile file("large.xml", LargeTree());
  Driver driver;
  driver.editor.Open(file.path());
  driver.Frames(8);
  const auto expect_readable = [&](const std::string& path) {
    driver.Frames(20);
    EXPECT_EQ(driver.Selected(), path);
    EXPECT_GE(driver.view().camera.zoom, kReadableNames) << path;
    const Box box = driver.BoxOf("canvas/T/" + path);
    const Box canvas = driver.BoxOf("canvas");
    EXPECT_TRUE(canvas.Contains(box.min) && canvas.Contains(box.max)) << path;
  };
  driver.Press(kKeyHome);
  ASSERT_LT(driver.view().camera.zoom, kReadableNames);
  driver.Press('F', kCtrl);
  driver.Type("name:drive 23");
  driver.Press(kKeyEnter);
  expect_readable("1.3.8");
  driver.Picture("find_hit");
  driver.Press(kKeyHome);
  driver.Press(kKeyF1 + 2);
  expect_readable("1.29.7");  // "drive 230"
}

}  // namespace
}  // namespace coppice::editor
