// The scrubber's terminal: raw keys in, pictures out.
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <iostream>

#include "bt_core/cli/replay/scrubber.h"

namespace coppice {
namespace {

// Keys come one by one and are not shown; everything is as before in the end.
class RawTerminal {
 public:
  RawTerminal() {
    tcgetattr(STDIN_FILENO, &before_);
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    std::cout << "\x1b[?1049h";  // the other screen
  }
  ~RawTerminal() {
    std::cout << "\x1b[?1049l" << std::flush;
    tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;

 private:
  termios before_;
};

std::string KeyOf(const std::string& bytes) {
  constexpr struct {
    const char* bytes;
    const char* key;
  } kKeys[] = {{"\x1b[D", "left"}, {"\x1b[C", "right"},   {"\x1b[A", "up"},
               {"\x1b[B", "down"}, {"\x1b[5~", "pageup"}, {"\x1b[6~", "pagedown"},
               {"\x1b[H", "home"}, {"\x1b[F", "end"},     {"\x1b[1~", "home"},
               {"\x1b[4~", "end"}, {"\x1b", "escape"},    {"\n", "enter"},
               {"\r", "enter"},    {"\x7f", "backspace"}, {"\b", "backspace"}};
  for (const auto& known : kKeys) {
    if (bytes == known.bytes) return known.key;
  }
  return bytes;
}

}  // namespace

int RunScrubber(const Recording& run) {
  if (run.ticks().empty()) {
    std::cerr << "there is no tick in this record\n";
    return 1;
  }
  const RawTerminal terminal;
  Scrubber scrubber(run);
  char bytes[16];
  while (true) {
    winsize size{};
    ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    std::cout << "\x1b[2J\x1b[H"
              << scrubber.Render(size.ws_row > 0 ? size.ws_row : 24,
                                 size.ws_col > 0 ? size.ws_col : 80)
              << std::flush;
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) return 0;
    if (!scrubber.Press(KeyOf(std::string(bytes, static_cast<std::size_t>(count))))) return 0;
  }
}

}  // namespace coppice
