// What the demonstration tells on the console: its steps, and a line that shows that time goes on.
#ifndef COPPICE_ROBOT_APP_APP_DEMO_CONSOLE_H_
#define COPPICE_ROBOT_APP_APP_DEMO_CONSOLE_H_

#include <chrono>
#include <iosfwd>
#include <string>

#include "robot_app/app/robot_watch.h"

namespace coppice::robot {

class DemoConsole {
 public:
  /// On a terminal the progress line is written over again and again.
  DemoConsole(std::ostream& out, bool is_terminal) : out_(out), is_terminal_(is_terminal) {}

  void Step(const std::string& text);
  void Tell(const std::string& text);
  /// At most every two seconds of real time.
  void Progress(const RobotView& view);

 private:
  void EndLine();

  std::ostream& out_;
  const bool is_terminal_;
  bool open_line_ = false;
  std::chrono::steady_clock::time_point last_{};
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_DEMO_CONSOLE_H_
