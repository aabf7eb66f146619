// Files that belong together, their pictures, and finding one's way in them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

class ProjectStory : public testing::Test {
 protected:
  ProjectStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }

  std::string Text() { return driver_.editor.state().workspace.project().Find(file_.path())->text; }
  static std::string Disk(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  // By its name, as people do who do not know the keys.
  void Run(const std::string& command) {
    driver_.Press('P', kCtrl);
    driver_.Type(command);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }
  void Replace(const std::string& text) {
    driver_.Press('A', kCtrl);
    driver_.Type(text);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }
  void DoubleClick(const std::string& item) {
    const Box box = driver_.BoxOf(item);
    driver_.ClickAt({box.min.x + 30, box.min.y + 8});
    driver_.ClickAt({box.min.x + 30, box.min.y + 8});
    driver_.Frames();
  }

  const TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(ProjectStory, ATreeOfAnotherFileIsIncludedAndUsed) {
  std::ofstream(file_.folder() + "/lamps.xml")
      << "<root BTCPP_format='4'><BehaviorTree ID='Lamps'><AlwaysSuccess/></BehaviorTree></root>";
  Run("include a file");
  Replace("lamps.xml");
  EXPECT_THAT(Text(), HasSubstr(R"(<include path="lamps.xml"/>)"));
  driver_.Frames(8);
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1"));
  driver_.Press(kKeyTab);
  driver_.Type("Lamps");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(<SubTree ID="Lamps")"));
}

TEST_F(ProjectStory, WhatSomebodyElseWritesIsShownAtOnceAndMergedWithMine) {
  std::string theirs = kSmallFile;
  theirs.replace(theirs.find("name=\"round\""), 12, "name=\"night\"");
  file_.Write(theirs);
  driver_.Frames(80);
  EXPECT_EQ(Text(), theirs);
  ASSERT_TRUE(driver_.Click("canvas/MainTree/1.3"));
  driver_.Press('D');
  theirs.replace(theirs.find("lamp=\"hall\""), 11, "lamp=\"attic\"");
  file_.Write(theirs);
  driver_.Frames(80);
  EXPECT_THAT(Text(), HasSubstr("lamp=\"attic\"")) << "theirs";
  EXPECT_THAT(Text(), HasSubstr("_skipIf")) << "mine";
}

TEST_F(ProjectStory, APictureOfTheTreeIsPaintedByKeys) {
  driver_.Press('E', kCtrl | kAlt);
  driver_.Frames();
  Replace(file_.folder() + "/tree.svg");
  EXPECT_THAT(Disk(file_.folder() + "/tree.svg"), HasSubstr(">round</text>"));
}

TEST_F(ProjectStory, ACommandGetsOtherKeys) {
  driver_.Press(kKeyF1);
  driver_.Type("view.compact");
  driver_.Press(kKeyEnter);
  driver_.Frames();
  driver_.Press('J', kCtrl | kAlt);
  driver_.Frames();
  driver_.Press(kKeyEscape);
  const bool before = driver_.editor.state().workspace.style().compact;
  driver_.Press('J', kCtrl | kAlt);
  EXPECT_NE(driver_.editor.state().workspace.style().compact, before);
}

TEST_F(ProjectStory, ASubTreeOpensWithADoubleClickAndTheTabLeadsBack) {
  DoubleClick("canvas/MainTree/1.2");
  EXPECT_TRUE(driver_.Has("canvas/Walk/1"));
  ASSERT_TRUE(driver_.Click("canvasbar/tab/MainTree"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("canvas/MainTree/1"));
  EXPECT_FALSE(driver_.Has("canvas/Walk/1"));
}

class LargeTreeStory : public testing::Test {
 protected:
  LargeTreeStory() {
    std::string text = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>)";
    for (int i = 0; i < 400; ++i) {
      text += "<Sequence name=\"part " + std::to_string(i) +
              "\"><AlwaysSuccess/><AlwaysSuccess/><Sleep msec=\"" + std::to_string(i) +
              "\"/></Sequence>";
    }
    file_.Write(text + "</Sequence></BehaviorTree></root>");
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
  }

  const TemporaryFile file_{"large.xml", ""};
  Driver driver_;
};

TEST_F(LargeTreeStory, TheSmallPictureLeadsToTheOtherEnd) {
  ASSERT_TRUE(driver_.Has("canvas/minimap"));
  driver_.Frames(60);
  const Point before = driver_.view().camera.offset;
  const Box map = driver_.BoxOf("canvas/minimap");
  driver_.ClickAt({map.center().x, map.max.y - 4});
  driver_.Frames(60);
  const Point after = driver_.view().camera.offset;
  EXPECT_GT(std::abs(after.x - before.x) + std::abs(after.y - before.y), 100);
  driver_.Picture("story_minimap");
}

TEST_F(LargeTreeStory, FoldingLeavesWhatOneWantsToSee) {
  ASSERT_TRUE(driver_.Click("canvas/Main/1.1"));
  const std::size_t before = driver_.view().shown().size();
  driver_.Press('C', kShift);
  driver_.Frames(60);
  EXPECT_LT(driver_.view().shown().size(), before / 2);
  EXPECT_TRUE(driver_.Has("canvas/Main/1.1.3"));
  driver_.Picture("story_folded");
}

}  // namespace
}  // namespace coppice::editor
