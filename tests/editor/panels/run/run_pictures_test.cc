#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"
#include "tests/editor/robot_face.h"

namespace coppice::editor {
namespace {

constexpr Color kEye = IM_COL32(0x48, 0xc8, 0xff, 255);
constexpr Color kStrip = IM_COL32(0x20, 0xe0, 0x40, 255);

class RunPictures : public ::testing::Test {
 protected:
  void ShowFace() {
    robot_.Show(RingEyes("LISTENING"));
    robot_.Show(Strip("ears", "85° 85°"));
    driver_.Frames();
    driver_.Press('V');
    driver_.Frames();
  }

  Driver driver_;
  ExecutedSource& robot_ = *AddExecuted(driver_, "robot:1", 10);
};

TEST_F(RunPictures, ShowTheFaceThatTheRobotHasNow) {
  ShowFace();
  const Box face = driver_.BoxOf("run/pictures/face");
  const Box ears = driver_.BoxOf("run/pictures/ears");
  EXPECT_GT(face.width(), 2 * ears.height()) << "the face is the larger one, and comes first";
  EXPECT_LE(face.max.x, ears.min.x);
  EXPECT_GT(driver_.CountColor(face, kEye, 8), 2000);
  EXPECT_GT(driver_.CountColor(ears, kStrip, 8), 500);

  LivePicture dark = RingEyes("SLEEP");
  std::fill(dark.rgb.begin(), dark.rgb.end(), 0);
  robot_.Show(dark);
  driver_.Frames();
  EXPECT_EQ(driver_.CountColor(face, kEye, 8), 0);
}

TEST_F(RunPictures, ARobotThatShowsNothingHasNoTab) {
  EXPECT_FALSE(driver_.Has("run/pictures"));
  EXPECT_EQ(driver_.editor.state().commands.Find("run.pictures")->WhyNot(),
            "the robot shows nothing to people");
  robot_.Show(RingEyes(""));
  driver_.Frames();
  EXPECT_TRUE(driver_.Click("run/pictures"));
  EXPECT_EQ(driver_.editor.state().run.tab, RunTab::kPictures);
}

TEST_F(RunPictures, OfARobotThatDoesNotAnswerNothingIsShown) {
  ShowFace();
  robot_.Disconnect("no answer");
  driver_.Frames();
  EXPECT_FALSE(driver_.Has("run/pictures/face"));
  robot_.Connect();
  robot_.Show(RingEyes("NEUTRAL"));
  driver_.Frames();
  EXPECT_TRUE(driver_.Has("run/pictures/face"));
}

TEST_F(RunPictures, WhatARobotSendsBeyondTheLimitsIsNotShown) {
  ShowFace();
  LivePicture short_one = RingEyes("x");
  short_one.rgb.resize(100);
  robot_.Show(short_one);
  robot_.Show({"wall", "", 4096, 4096, {}});
  for (int i = 0; i < 100; ++i) robot_.Show(Strip("lamp " + std::to_string(i), ""));
  driver_.Frames();
  EXPECT_EQ(driver_.editor.state().workspace.run()->pictures().all().size(),
            PictureSet::kMostPictures);
  EXPECT_GT(driver_.CountColor(driver_.BoxOf("run/pictures/face"), kEye, 8), 500);
  EXPECT_FALSE(driver_.Has("run/pictures/wall"));
}

// As many triangles as a robot can have drawn, in lines and with words that are no face's.
TEST_F(RunPictures, TheWorstThatKeepsTheLimitsIsDrawn) {
  const std::string odd = "a\nb\x01%s##" + std::string(200, 'W');
  for (const auto& [width, height] : {std::pair(4000, 1), std::pair(1, 90)}) {
    const std::size_t bytes = std::size_t{3} * width * height;
    robot_.Show({"line\n" + std::to_string(width), odd, static_cast<std::uint32_t>(width),
                 static_cast<std::uint32_t>(height), std::vector<std::uint8_t>(bytes, 0xff)});
  }
  driver_.Frames();
  driver_.Press('V');
  driver_.Frames();
  const Box tile = driver_.BoxOf("run");
  EXPECT_TRUE(driver_.Has("run/pictures/line\n4000"));
  EXPECT_LE(driver_.BoxOf("run/pictures/line\n4000").max.x, tile.max.x + 1);
}

}  // namespace
}  // namespace coppice::editor
