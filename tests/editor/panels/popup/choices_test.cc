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

}  // namespace
}  // namespace coppice::editor
