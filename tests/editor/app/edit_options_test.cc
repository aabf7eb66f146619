#include "editor/app/edit_options.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(EditOptions, ReadsEverythingInAnyOrder) {
  const EditOptions options = ParseEditOptions(
      {"a.xml",      "--connect",       "h:1",   "--size",    "640x480",  "b.xml",   "--connect",
       "h:2",        "--palette",       "light", "--picture", "p.png",    "--every", "0.5",
       "--headless", "--reduce-motion", "--for", "3",         "--models", "m.xml"});
  ASSERT_FALSE(options.exit);
  EXPECT_EQ(options.files, (std::vector<std::string>{"a.xml", "b.xml"}));
  EXPECT_EQ(options.robots, (std::vector<std::string>{"h:1", "h:2"}));
  EXPECT_EQ(options.models, (std::vector<std::string>{"m.xml"}));
  EXPECT_EQ(options.width, 640);
  EXPECT_EQ(options.height, 480);
  EXPECT_EQ(options.palette, PaletteName::kLight);
  EXPECT_EQ(options.picture_every, 0.5);
  EXPECT_EQ(options.run_for, 3);
  EXPECT_TRUE(options.headless);
  EXPECT_TRUE(options.reduce_motion);
}

TEST(EditOptions, WhatIsNotSaidIsAsTheLastTime) {
  const EditOptions options = ParseEditOptions({"a.xml"});
  EXPECT_FALSE(options.palette);
  EXPECT_EQ(options.width, 0);
}

TEST(EditOptions, SaysWhatIsWrong) {
  const std::vector<std::vector<std::string>> kWrong = {
      {"--size", "12"}, {"--size", "10x10"}, {"--palette", "pink"}, {"--every", "soon"},
      {"--for", "-1"},  {"--connect"},       {"--unknown"},
  };
  for (const auto& arguments : kWrong) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(ParseEditOptions(arguments).exit, 2);
    const std::string error = testing::internal::GetCapturedStderr();
    EXPECT_NE(error.find(arguments[0]), std::string::npos) << error;
  }
}

TEST(EditOptions, HelpIsNoError) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(ParseEditOptions({"--help"}).exit, 0);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("--connect HOST:PORT"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
