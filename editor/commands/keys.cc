#include "editor/commands/keys.h"

namespace coppice::editor {
namespace {

std::string NameOf(Key key) {
  if (key >= kKeyF1 && key < kKeyF1 + 24) return "F" + std::to_string(key - kKeyF1 + 1);
  if (key > kKeySpace && key < 128) return std::string(1, static_cast<char>(key));
  switch (key) {
    case kKeySpace:
      return "Space";
    case kKeyEscape:
      return "Esc";
    case kKeyEnter:
      return "Enter";
    case kKeyTab:
      return "Tab";
    case kKeyDelete:
      return "Del";
    case kKeyRight:
      return "Right";
    case kKeyLeft:
      return "Left";
    case kKeyDown:
      return "Down";
    case kKeyUp:
      return "Up";
    case kKeyHome:
      return "Home";
    case kKeyEnd:
      return "End";
    default:
      return "key " + std::to_string(key);
  }
}

}  // namespace

std::string ToString(KeyChord chord) {
  if (chord.key == 0) return {};
  std::string text;
  if (chord.modifiers & kCtrl) text += "Ctrl+";
  if (chord.modifiers & kAlt) text += "Alt+";
  if (chord.modifiers & kShift) text += "Shift+";
  return text + NameOf(chord.key);
}

}  // namespace coppice::editor
