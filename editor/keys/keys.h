// Keys by number. The numbers are those of GLFW 3, so that the window need not translate; printable
// keys are their upper-case ASCII letter.
#ifndef COPPICE_EDITOR_KEYS_KEYS_H_
#define COPPICE_EDITOR_KEYS_KEYS_H_

#include <optional>
#include <string>
#include <string_view>

namespace coppice::editor {

using Key = int;

inline constexpr Key kKeySpace = 32;
inline constexpr Key kKeyPeriod = 46;
inline constexpr Key kKeyEscape = 256;
inline constexpr Key kKeyEnter = 257;
inline constexpr Key kKeyTab = 258;
inline constexpr Key kKeyBackspace = 259;
inline constexpr Key kKeyInsert = 260;
inline constexpr Key kKeyDelete = 261;
inline constexpr Key kKeyRight = 262;
inline constexpr Key kKeyLeft = 263;
inline constexpr Key kKeyDown = 264;
inline constexpr Key kKeyUp = 265;
inline constexpr Key kKeyPageUp = 266;
inline constexpr Key kKeyPageDown = 267;
inline constexpr Key kKeyHome = 268;
inline constexpr Key kKeyEnd = 269;
inline constexpr Key kKeyF1 = 290;  ///< F2 is 291, and so on
inline constexpr Key kKeyKeypadEnter = 335;
inline constexpr Key kKeyLeftShift = 340;  ///< then Ctrl, Alt, Super; then the right ones
inline constexpr Key kKeyLeftAlt = 342;
inline constexpr Key kKeyMenu = 348;

/// Shift, Ctrl, Alt and Super, left and right.
constexpr bool IsModifier(Key key) { return key >= kKeyLeftShift && key < kKeyLeftShift + 8; }

enum Modifier : int { kNoModifier = 0, kShift = 1, kCtrl = 2, kAlt = 4, kSuper = 8 };

struct KeyEvent {
  Key key = 0;
  bool down = true;
  int modifiers = kNoModifier;
};

/// A key with modifiers, as it is bound to a command.
struct KeyChord {
  Key key = 0;  ///< 0: none
  int modifiers = kNoModifier;
};
inline bool operator==(KeyChord a, KeyChord b) {
  return a.key == b.key && a.modifiers == b.modifiers;
}

/// "Ctrl+O", "F4", "."; empty for none.
std::string ToString(KeyChord chord);

/// What ToString writes, in any case; an empty text is no key. Nothing if it is anything else.
std::optional<KeyChord> KeysFromString(std::string_view text);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_KEYS_H_
