// A terminal that is drawn in place, and its keys.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_TERMINAL_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_TERMINAL_H_

#include <termios.h>

#include <cstddef>
#include <string>
#include <vector>

namespace coppice {

/// True if the output goes to a terminal.
bool HasTerminal();

/// Takes the terminal over and gives it back as it was.
class LiveTerminal {
 public:
  LiveTerminal();
  ~LiveTerminal();
  LiveTerminal(const LiveTerminal&) = delete;
  LiveTerminal& operator=(const LiveTerminal&) = delete;

  struct Size {
    std::size_t rows = 0;  ///< 0: not known
    std::size_t columns = 0;
  };
  Size size() const;

  void Draw(const std::vector<std::string>& lines);

  /// The next key that was pressed; 0: none.
  char Key();

 private:
  bool has_keys_;
  termios before_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_TERMINAL_H_
