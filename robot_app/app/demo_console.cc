#include "robot_app/app/demo_console.h"

#include <iomanip>
#include <ostream>
#include <sstream>

namespace coppice::robot {

void DemoConsole::Step(const std::string& text) {
  EndLine();
  out_ << "==> " << text << std::endl;
}

void DemoConsole::Tell(const std::string& text) {
  EndLine();
  out_ << "    " << text << std::endl;
}

void DemoConsole::Progress(const RobotView& view) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::seconds(2)) return;
  last_ = now;
  std::ostringstream line;
  line << std::fixed << std::setprecision(1) << "    t = " << view.time << " s   at (" << view.x
       << ", " << view.y << ")   driven " << view.distance << " m   " << view.configuration << "   "
       << (view.errors.empty() ? "no faults" : view.errors.front());
  if (!is_terminal_) {
    out_ << line.str() << std::endl;
    return;
  }
  out_ << "\r\033[K" << line.str().substr(0, 110) << std::flush;
  open_line_ = true;
}

void DemoConsole::EndLine() {
  if (open_line_) out_ << "\r\033[K";
  open_line_ = false;
}

}  // namespace coppice::robot
