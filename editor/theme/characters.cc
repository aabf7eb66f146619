#include "editor/theme/characters.h"

#include <imgui_internal.h>

#include <cstdint>
#include <cstring>

namespace coppice::editor {
namespace {

// · × – … › → ⇉ and the box for what no font has.
constexpr ImWchar kUsual[] = {0x0020, 0x007E, 0x00B7, 0x00B7, 0x00D7, 0x00D7, 0x2013,
                              0x2013, 0x2026, 0x2026, 0x203A, 0x203A, 0x2192, 0x2192,
                              0x21C9, 0x21C9, 0x25AF, 0x25AF, 0};

struct Range {
  ImWchar first, last;
};

constexpr Range kAlphabets[] = {{0x00A1, 0x017F},   // Latin
                                {0x0386, 0x03CE},   // Greek
                                {0x0400, 0x045F},   // Cyrillic
                                {0x2010, 0x2025},   // dashes and quotes
                                {0x2190, 0x2193},   // arrows
                                {0x2248, 0x2265},   // comparisons
                                {0x25A0, 0x25CF}};  // shapes

constexpr Range kEastAsian[] = {
    {0x1100, 0x11FF}, {0x2E80, 0xD7FF}, {0xF900, 0xFAFF}, {0xFE30, 0xFE4F}, {0xFF00, 0xFFEF}};

constexpr Range kPrivate = {0xE000, 0xF8FF};  // the icons are there

bool IsIn(const Range& range, ImWchar code) { return code >= range.first && code <= range.last; }

bool IsUsual(ImWchar code) {
  for (const ImWchar* range = kUsual; *range != 0; range += 2) {
    if (IsIn({range[0], range[1]}, code)) return true;
  }
  return false;
}

// Control characters and what is no character are nowhere.
bool IsCharacter(unsigned code) {
  return code >= 0xA0 && code < IM_UNICODE_CODEPOINT_INVALID &&
         !IsIn(kPrivate, static_cast<ImWchar>(code));
}

// The first byte that is not ASCII: eight at a time, since nearly all texts are nothing else.
const char* SkipAscii(const char* at, const char* end) {
  for (std::uint64_t eight = 0; end - at >= 8; at += 8) {
    std::memcpy(&eight, at, 8);
    if ((eight & 0x8080808080808080U) != 0) break;
  }
  while (at < end && static_cast<unsigned char>(*at) < 0x80) ++at;
  return at;
}

void AddAll(const Range& range, CharacterSet& to) {
  for (ImWchar code = range.first; code <= range.last; ++code) to.insert(to.end(), code);
}

}  // namespace

const ImWchar* UsualCharacters() { return kUsual; }

CharacterSet UnusualCharacters(std::string_view text) {
  CharacterSet found;
  const char* const end = text.data() + text.size();
  const char* at = SkipAscii(text.data(), end);
  while (at < end) {
    unsigned code = 0;
    at += ImTextCharFromUtf8(&code, at, end);
    if (IsCharacter(code) && !IsUsual(static_cast<ImWchar>(code))) {
      found.insert(static_cast<ImWchar>(code));
    }
    at = SkipAscii(at, end);
  }
  return found;
}

CharacterSet WithAlphabets(const CharacterSet& characters) {
  CharacterSet all = characters;
  for (const Range& range : kAlphabets) {
    const auto first = characters.lower_bound(range.first);
    if (first != characters.end() && *first <= range.last) AddAll(range, all);
  }
  return all;
}

CharacterSet Alphabets() {
  CharacterSet all;
  for (const Range& range : kAlphabets) AddAll(range, all);
  return all;
}

bool IsEastAsian(ImWchar character) {
  for (const Range& range : kEastAsian) {
    if (IsIn(range, character)) return true;
  }
  return false;
}

}  // namespace coppice::editor
