#include "editor/keys/keys.h"

#include <algorithm>

namespace coppice::editor {
namespace {

struct NamedKey {
  Key key;
  std::string_view name;
};
constexpr NamedKey kNamed[] = {{kKeySpace, "Space"},
                               {kKeyEscape, "Esc"},
                               {kKeyEnter, "Enter"},
                               {kKeyTab, "Tab"},
                               {kKeyBackspace, "Backspace"},
                               {kKeyInsert, "Ins"},
                               {kKeyDelete, "Del"},
                               {kKeyRight, "Right"},
                               {kKeyLeft, "Left"},
                               {kKeyDown, "Down"},
                               {kKeyUp, "Up"},
                               {kKeyPageUp, "PageUp"},
                               {kKeyPageDown, "PageDown"},
                               {kKeyHome, "Home"},
                               {kKeyEnd, "End"},
                               {kKeyKeypadEnter, "KeypadEnter"},
                               {kKeyMenu, "Menu"}};
struct NamedModifier {
  Modifier modifier;
  std::string_view prefix;
};
constexpr NamedModifier kModifiers[] = {
    {kCtrl, "Ctrl+"}, {kAlt, "Alt+"}, {kShift, "Shift+"}, {kSuper, "Super+"}};
constexpr Key kFunctionKeys = 24;

std::string NameOf(Key key) {
  if (key >= kKeyF1 && key < kKeyF1 + kFunctionKeys) {
    return "F" + std::to_string(key - kKeyF1 + 1);
  }
  if (key > kKeySpace && key < 128) return std::string(1, static_cast<char>(key));
  for (const NamedKey& named : kNamed) {
    if (named.key == key) return std::string(named.name);
  }
  return "key " + std::to_string(key);
}

char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool IsSame(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return Upper(x) == Upper(y); });
}

std::optional<Key> KeyFromString(std::string_view name) {
  if (name.size() == 1 && name[0] > ' ' && name[0] < 127) return Upper(name[0]);
  for (Key key = kKeyF1; key < kKeyF1 + kFunctionKeys; ++key) {
    if (IsSame(name, NameOf(key))) return key;
  }
  for (const NamedKey& named : kNamed) {
    if (IsSame(name, named.name)) return named.key;
  }
  return std::nullopt;
}

}  // namespace

std::string ToString(KeyChord chord) {
  if (chord.key == 0) return {};
  std::string text;
  for (const NamedModifier& named : kModifiers) {
    if (chord.modifiers & named.modifier) text += named.prefix;
  }
  return text + NameOf(chord.key);
}

std::optional<KeyChord> KeysFromString(std::string_view text) {
  KeyChord chord;
  if (text.empty()) return chord;
  for (bool found = true; found;) {
    found = false;
    for (const NamedModifier& named : kModifiers) {
      if (text.size() <= named.prefix.size() ||
          !IsSame(text.substr(0, named.prefix.size()), named.prefix)) {
        continue;
      }
      chord.modifiers |= named.modifier;
      text.remove_prefix(named.prefix.size());
      found = true;
    }
  }
  const std::optional<Key> key = KeyFromString(text);
  if (!key) return std::nullopt;
  chord.key = *key;
  return chord;
}

}  // namespace coppice::editor
