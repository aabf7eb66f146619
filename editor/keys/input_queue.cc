#include "editor/keys/input_queue.h"

#include <algorithm>

namespace coppice::editor {
namespace {

// What a frame has seen so far.
struct Seen {
  std::vector<int> keys;
  std::vector<int> buttons;
  bool something = false;  // that Shift, Ctrl, Alt or Super gives another meaning

  // A click must be seen where it happened: the mouse may not move after a button did. And a key, a
  // click or a turn of the wheel with the modifiers that it had.
  bool Blocks(const InputEvent& event) const {
    if (const auto* key = std::get_if<KeyEvent>(&event)) {
      return Has(keys, key->key) || (something && IsModifier(key->key));
    }
    if (std::get_if<MouseMove>(&event)) return !buttons.empty();
    if (const auto* button = std::get_if<MouseButton>(&event)) return Has(buttons, button->button);
    return false;
  }

  void Note(const InputEvent& event) {
    if (const auto* key = std::get_if<KeyEvent>(&event)) keys.push_back(key->key);
    if (const auto* button = std::get_if<MouseButton>(&event)) buttons.push_back(button->button);
    const auto* key = std::get_if<KeyEvent>(&event);
    something = something || (key && !IsModifier(key->key)) || std::get_if<MouseButton>(&event) ||
                std::get_if<MouseWheel>(&event);
  }

  static bool Has(const std::vector<int>& all, int one) {
    return std::find(all.begin(), all.end(), one) != all.end();
  }
};

}  // namespace

void InputQueue::Add(const std::vector<InputEvent>& events) {
  events_.insert(events_.end(), events.begin(), events.end());
}

std::vector<InputEvent> InputQueue::TakeFrame() {
  std::vector<InputEvent> frame;
  Seen seen;
  while (!events_.empty() && !seen.Blocks(events_.front())) {
    seen.Note(events_.front());
    frame.push_back(std::move(events_.front()));
    events_.pop_front();
  }
  return frame;
}

}  // namespace coppice::editor
