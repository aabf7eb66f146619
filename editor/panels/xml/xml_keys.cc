#include "editor/panels/xml/xml_keys.h"

#include <optional>

namespace coppice::editor {
namespace {

std::optional<TextStep> StepOf(Key key, bool ctrl) {
  switch (key) {
    case kKeyLeft:
      return ctrl ? TextStep::kWordLeft : TextStep::kLeft;
    case kKeyRight:
      return ctrl ? TextStep::kWordRight : TextStep::kRight;
    case kKeyUp:
      return TextStep::kUp;
    case kKeyDown:
      return TextStep::kDown;
    case kKeyPageUp:
      return TextStep::kPageUp;
    case kKeyPageDown:
      return TextStep::kPageDown;
    case kKeyHome:
      return ctrl ? TextStep::kTextStart : TextStep::kLineStart;
    case kKeyEnd:
      return ctrl ? TextStep::kTextEnd : TextStep::kEnd;
    default:
      return std::nullopt;
  }
}

}  // namespace

bool IsTextKey(KeyChord chord) {
  if ((chord.modifiers & (kAlt | kSuper)) != 0) return false;
  const bool ctrl = (chord.modifiers & kCtrl) != 0;
  if (StepOf(chord.key, ctrl)) return true;
  if (ctrl) {
    const bool shift = (chord.modifiers & kShift) != 0;
    const Key key = chord.key;
    return !shift && (key == 'A' || key == 'C' || key == 'X' || key == 'V');
  }
  switch (chord.key) {
    case kKeyEnter:
    case kKeyKeypadEnter:
    case kKeyTab:
    case kKeyBackspace:
    case kKeyDelete:
    case kKeyEscape:
      return true;
    default:
      return chord.key >= kKeySpace && chord.key < kKeyEscape;
  }
}

void PressTextKey(KeyChord chord, const TextClipboard& clipboard, TextEdit& edit) {
  const bool ctrl = (chord.modifiers & kCtrl) != 0;
  const bool shift = (chord.modifiers & kShift) != 0;
  if (const auto step = StepOf(chord.key, ctrl)) return edit.Move(*step, shift);
  if (ctrl) {
    if (chord.key == 'A') return edit.SelectAll();
    if (chord.key == 'V') return edit.Put(clipboard.get());
    if (edit.at == edit.anchor) return;
    clipboard.set(std::string(edit.selected()));
    if (chord.key == 'X') edit.Put("");
    return;
  }
  switch (chord.key) {
    case kKeyEnter:
    case kKeyKeypadEnter:
      return edit.PutLineEnd();
    case kKeyTab:
      return edit.Put("  ");
    case kKeyBackspace:
      return edit.Erase(false);
    case kKeyDelete:
      return edit.Erase(true);
    default:
      return;
  }
}

}  // namespace coppice::editor
