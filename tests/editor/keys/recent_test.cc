#include "editor/keys/recent.h"

#include <gmock/gmock.h>

#include "editor/keys/fuzzy.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;

TEST(Recent, WhatIsUsedAgainComesToTheFront) {
  std::vector<std::string> list = {"b", "a"};
  UseAgain(list, "a");
  EXPECT_THAT(list, ElementsAre("a", "b"));
}

TEST(Recent, ForgetsWhatWasNotUsedForLongest) {
  std::vector<std::string> list;
  for (int i = 0; i < 20; ++i) UseAgain(list, std::to_string(i));
  EXPECT_THAT(list, ElementsAre("19", "18", "17", "16", "15", "14", "13", "12"));
}

TEST(Recent, TheBonusIsLargerTheLaterItWasUsed) {
  const std::vector<std::string> list = {"new", "old"};
  EXPECT_GT(BonusOf(list, "new"), BonusOf(list, "old"));
  EXPECT_EQ(BonusOf(list, "never"), 0);
}

TEST(Recent, ReadsWhatItWrites) {
  Recent recent;
  recent.files = {"/a b.xml", "/c.coppice"};
  recent.types = {"Wait"};
  recent.choices = {"command Fit all"};
  const Recent read = ReadRecent(WriteRecent(recent));
  EXPECT_EQ(read.files, recent.files);
  EXPECT_EQ(read.types, recent.types);
  EXPECT_EQ(read.choices, recent.choices);
}

TEST(Recent, KeepsRobotsBesideTheFiles) {
  Recent recent;
  recent.files = {"/a.xml"};
  recent.robots = {{"new:1667", "Patrol", 60}, {"old:1667", "", 0}};
  const Recent read = ReadRecent(WriteRecent(recent));
  EXPECT_EQ(read.files, recent.files);
  ASSERT_EQ(read.robots.size(), 2U);
  EXPECT_EQ(LineOf(read.robots[0]), LineOf(recent.robots[0]));
  EXPECT_EQ(LineOf(read.robots[1]), LineOf(recent.robots[1]));
}

TEST(Recent, ReadsAListOfPathsAlone) {
  EXPECT_THAT(ReadRecent("/a.xml\n\n/b.xml\n").files, ElementsAre("/a.xml", "/b.xml"));
}

}  // namespace
}  // namespace coppice::editor
