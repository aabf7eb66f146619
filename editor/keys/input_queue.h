// What the user did, in order, dealt out frame by frame.
//
// Dear ImGui 1.86 looks at the state of keys and buttons once per frame, so a press and a release
// between two frames would be lost. The queue gives each frame as many events as it can see without
// losing one: the release of a key or button that was pressed in this frame waits for the next, and
// so does a modifier that is pressed or let go after something that it would give another meaning.
#ifndef COPPICE_EDITOR_KEYS_INPUT_QUEUE_H_
#define COPPICE_EDITOR_KEYS_INPUT_QUEUE_H_

#include <deque>
#include <string>
#include <variant>
#include <vector>

#include "editor/keys/keys.h"

namespace coppice::editor {

struct MouseMove {
  float x = 0;
  float y = 0;
};
struct MouseButton {
  int button = 0;  ///< 0 left, 1 right, 2 middle
  bool down = true;
};
struct MouseWheel {
  float x = 0;
  float y = 0;  ///< positive: away from the user
};
struct TypedText {
  std::string utf8;
};

using InputEvent = std::variant<MouseMove, MouseButton, MouseWheel, TypedText, KeyEvent>;

/// What is to be shown, and what happened since the last frame.
struct InputEvents {
  std::vector<InputEvent> events;  ///< in order
  float width = 1280;              ///< of the window, in pixels
  float height = 800;
  float dt = 1.0F / 60;  ///< since the last frame [s]
};

/// Shape of the mouse cursor that the window should show.
enum class CursorShape { kArrow, kText, kResizeAcross, kResizeDown, kHand };

class InputQueue {
 public:
  void Add(const std::vector<InputEvent>& events);

  /// The events of one frame; the rest stays.
  std::vector<InputEvent> TakeFrame();

  /// True if another frame is needed at once.
  bool pending() const { return !events_.empty(); }

 private:
  std::deque<InputEvent> events_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_INPUT_QUEUE_H_
