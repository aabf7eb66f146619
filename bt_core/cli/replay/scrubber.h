// The view of `coppice replay FILE` in a terminal: the tree at one tick, and keys to go back and
// forth.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_SCRUBBER_H_
#define COPPICE_BT_CORE_CLI_REPLAY_SCRUBBER_H_

#include <cstddef>
#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// What the view shows, and what a key does to it; without a terminal.
class Scrubber {
 public:
  /// There is at least one tick.
  explicit Scrubber(const Recording& run);

  /// A key: "j", "left", "pageup", "enter", "backspace", ... False: the view is to be closed.
  bool Press(const std::string& key);

  /// The picture, at most so many lines and columns.
  std::string Render(std::size_t lines, std::size_t columns) const;

  std::size_t entry() const { return entry_; }
  NodeIndex node() const { return node_; }

 private:
  bool PressInPrompt(const std::string& key);
  void Answer();
  void Move(std::int64_t entries);
  void GoTo(std::size_t entry);
  void GoToChange(int direction);
  bool Differs(std::size_t entry) const;
  void Search(const std::string& text);
  void Explain();
  const TreeDescription& tree() const;

  const Recording& run_;
  std::size_t entry_;
  NodeIndex node_{0};
  std::string prompt_;  // what is asked for: "tick", "time", "search"; empty: nothing
  std::string typed_;
  std::string searched_;
  std::string message_;  // below the tree
};

/// Shows it until it is closed. Returns 0.
int RunScrubber(const Recording& run);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_SCRUBBER_H_
