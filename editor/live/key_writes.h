// Values that the user writes into a run: each becomes a value of the type that the key has, and
// waits until the run shows it.
//
//   KeyWrites writes;
//   writes.Send(view, slot, "0.5");       // what the user has typed
//   writes.IsWaiting(view, slot);         // until the next tick has come
#ifndef COPPICE_EDITOR_LIVE_KEY_WRITES_H_
#define COPPICE_EDITOR_LIVE_KEY_WRITES_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/live/run_view.h"

namespace coppice::editor {

/// The command that writes it. `present`: bytes of the value that the key has (data/value_bytes.h).
/// A key of which no node says the type gets a value of the type of the present one; the problem is
/// that the text is none.
Expected<LiveCommand> WriteOf(const TreeDescription& tree, SlotIndex slot,
                              const std::string& present, const std::string& text);

/// What a command of WriteOf writes, if it is a text whatever stands in it.
std::optional<std::string> TextOf(const LiveCommand& write);

class KeyWrites {
 public:
  /// The slot is one of the shown tree. What the robot refuses becomes the answer of the view.
  Outcome Send(RunView& view, SlotIndex slot, const std::string& text);

  /// The run does not show it yet.
  bool IsWaiting(const RunView& view, SlotIndex slot) const;

 private:
  struct Waiting {
    std::string run;
    std::string path;    // "SCOPE/KEY"
    std::size_t ticks;   // of the run as it was sent
    std::size_t writes;  // of the slot
    std::shared_ptr<bool> is_refused;
  };

  std::vector<Waiting> waiting_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_LIVE_KEY_WRITES_H_
