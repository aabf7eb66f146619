#include "robot_app/app/demo_console.h"

#include <gtest/gtest.h>

#include <sstream>

namespace coppice::robot {
namespace {

TEST(DemoConsole, ShowsPlaceAndFirstFaultInTheProgressLine) {
  std::ostringstream out;
  RobotView view;
  view.x = 12.34;
  view.errors = {"node /a: does not answer"};
  DemoConsole(out, false).Progress(view);
  EXPECT_NE(out.str().find("at (12.3, 0.0)"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("node /a: does not answer"), std::string::npos);
}

TEST(DemoConsole, DoesNotRepeatTheProgressLineAtOnce) {
  std::ostringstream out;
  DemoConsole console(out, false);
  console.Progress(RobotView());
  const std::string once = out.str();
  console.Progress(RobotView());
  EXPECT_EQ(out.str(), once);
}

TEST(DemoConsole, ClearsTheProgressLineOfATerminalBeforeAStep) {
  std::ostringstream out;
  DemoConsole console(out, true);
  console.Progress(RobotView());
  console.Step("next");
  EXPECT_NE(out.str().find("\r\033[K==> next\n"), std::string::npos);
}

}  // namespace
}  // namespace coppice::robot
