#include "editor/panels/popup/choices.h"

#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

TEST(Choices, OfferCommandsNodesTreesAndRobots) {
  const TemporaryFile file("small.xml", kSmallFile);
  Driver driver;
  driver.editor.Open(file.path());
  driver.AddRobot("robot:1", kLiveTree);
  const auto best = [&](const std::string& typed) {
    const auto choices = FindChoices(driver.editor.state(), typed, 0, 5);
    return choices.empty() ? "" : choices[0].kind + " " + choices[0].title;
  };
  EXPECT_EQ(best("fit all"), "command Fit all");
  EXPECT_EQ(best("isready"), "node IsReady");
  EXPECT_EQ(best("maintree"), "tree MainTree");
  EXPECT_EQ(best("robot:1"), "robot robot:1");
  EXPECT_EQ(best("qqqqq"), "");
}

TEST(Choices, AreNoMoreThanAskedFor) {
  Driver driver;
  EXPECT_EQ(FindChoices(driver.editor.state(), "", 0, 4).size(), 4U);
}

TEST(Choices, OfThoseThatFitAlikeWhatWasUsedLastComesFirst) {
  Driver driver;
  EditorState& state = driver.editor.state();
  const auto titles = [&] {
    std::vector<std::string> all;
    for (const Choice& choice : FindChoices(state, "tile", 0, 30)) all.push_back(choice.title);
    return all;
  };
  ASSERT_NE(titles().front(), "Timeline tile");
  for (const Choice& choice : FindChoices(state, "tile", 0, 30)) {
    if (choice.title == "Timeline tile") choice.run();
  }
  EXPECT_EQ(titles().front(), "Timeline tile");
}

TEST(Choices, WhatWasUsedLastIsKnownAfterARestart) {
  const TemporaryFile recent("recent", "");
  EditorOptions options;
  options.recent_file = recent.path();
  {
    Driver driver(options);
    driver.Press('P', kCtrl);
    driver.Type("Minimap");
    driver.Press(kKeyEnter);
  }
  Driver driver(options);
  EXPECT_EQ(FindChoices(driver.editor.state(), "", 0, 1).front().title, "Minimap");
}

}  // namespace
}  // namespace coppice::editor
