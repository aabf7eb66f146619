#include "bt_core/cli/live/live_terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <iostream>

namespace coppice {
namespace {

// ECMA-48 and xterm: the other screen, without a cursor, and back.
constexpr char kEnter[] = "\x1b[?1049h\x1b[?25l";
constexpr char kLeave[] = "\x1b[?25h\x1b[?1049l";

}  // namespace

bool HasTerminal() { return isatty(STDOUT_FILENO) != 0; }

LiveTerminal::LiveTerminal() : has_keys_(tcgetattr(STDIN_FILENO, &before_) == 0) {
  if (has_keys_) {
    termios keys = before_;
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &keys);
  }
  std::cout << kEnter << std::flush;
}

LiveTerminal::~LiveTerminal() {
  std::cout << kLeave << std::flush;
  if (has_keys_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

LiveTerminal::Size LiveTerminal::size() const {
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0) return {};
  return {window.ws_row, window.ws_col};
}

void LiveTerminal::Draw(const std::vector<std::string>& lines) {
  std::string text = "\x1b[H";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += (i > 0 ? "\r\n" : "") + lines[i] + "\x1b[K";
  }
  std::cout << text << "\x1b[J" << std::flush;
}

char LiveTerminal::Key() {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  char key = 0;
  if (!has_keys_ || poll(&input, 1, 0) <= 0 || read(STDIN_FILENO, &key, 1) != 1) return 0;
  return key;
}

}  // namespace coppice
