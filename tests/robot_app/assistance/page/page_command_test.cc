#include "robot_app/assistance/page/page_command.h"

#include <gtest/gtest.h>

#include <random>

namespace coppice::robot::assistance {
namespace {

using Kind = PageCommand::Kind;

TEST(PageCommand, IsReadFromAnObject) {
  const auto drive =
      ReadPageCommand(R"({"do": "drive", "linear": 0.2, "angular": -1, "beat": 1500})");
  ASSERT_TRUE(drive);
  EXPECT_EQ(drive->kind, Kind::kDrive);
  EXPECT_EQ(drive->velocity.linear, 0.2);
  EXPECT_EQ(drive->velocity.angular, -1);
  EXPECT_EQ(drive->beat, Time(std::chrono::milliseconds(1500)));
  const auto answer = ReadPageCommand(R"({"do": "answer", "request": 7, "fixed": true})");
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->request, 7u);
  EXPECT_TRUE(answer->fixed);
  EXPECT_TRUE(ReadPageCommand(R"({"do": "take", "over": true})")->take_over);
  EXPECT_EQ(ReadPageCommand(R"({"do": "restart", "name": "navigation"})")->name, "navigation");
  EXPECT_EQ(ReadPageCommand(R"({"do": "cameras", "names": ["front"]})")->names.size(), 1u);
  EXPECT_EQ(ReadPageCommand(R"({"do": "set_pose", "x": 1, "y": 2, "yaw": 3})")->pose.yaw, 3);
}

TEST(PageCommand, WhatIsNoneIsRefused) {
  for (const char* const text :
       {"",
        "null",
        "[]",
        "{}",
        "{\"do\": 1}",
        R"({"do": "explode"})",
        R"({"do": "drive"})",
        R"({"do": "drive", "linear": "1", "angular": 0, "beat": 1})",
        R"({"do": "drive", "linear": 1e308, "angular": 0, "beat": 1})",
        R"({"do": "drive", "linear": null, "angular": 0, "beat": 1})",
        R"({"do": "drive", "linear": 1, "angular": 0})",
        R"({"do": "drive", "linear": 1, "angular": 0, "beat": -1})",
        R"({"do": "drive", "linear": 1, "angular": 0, "beat": 0.5})",
        R"({"do": "drive", "linear": 1, "angular": 0, "beat": 18446744073709551615})",
        R"({"do": "set_pose", "x": 1, "y": 2})",
        R"({"do": "answer", "request": -1, "fixed": true})",
        R"({"do": "answer", "request": 1, "fixed": "yes"})",
        R"({"do": "cameras", "names": ["","","","","","","","",""]})",
        R"({"do": "cameras", "names": [1]})",
        "\xff\xfe"}) {
    EXPECT_FALSE(ReadPageCommand(text)) << text;
  }
  EXPECT_FALSE(ReadPageCommand(std::string(100000, '[')));
}

TEST(PageCommand, NoBytesDoHarm) {
  const std::string good = R"({"do": "set_pose", "x": 1.5, "y": 2, "yaw": 3, "names": ["a"]})";
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text = good;
    for (unsigned edits = random() % 6; edits > 0; --edits) {
      text[random() % text.size()] = static_cast<char>(random());
    }
    ReadPageCommand(text.substr(0, random() % (text.size() + 1)));
  }
}

TEST(PageCommand, ViewersMayOnlyChooseCameras) {
  EXPECT_TRUE(IsForViewers(Kind::kCameras));
  for (const Kind kind :
       {Kind::kTake, Kind::kLeave, Kind::kDrive, Kind::kSetPose, Kind::kAnswer, Kind::kRestart}) {
    EXPECT_FALSE(IsForViewers(kind));
  }
}

}  // namespace
}  // namespace coppice::robot::assistance
