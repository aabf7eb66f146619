#include "bt_core/model/utf8.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace coppice {
namespace {

struct Character {
  std::size_t length = 0;  // 0: there is none
  std::uint32_t code = 0;
};

// At the start of the text.
Character FirstCharacter(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {1, first};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return {};
  std::uint32_t code = first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (overlong || surrogate || code > 0x10FFFF) return {};
  return {length, code};
}

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};
constexpr Range kUnseen[] = {
    {0x00, 0x1F},     {0x7F, 0x9F},     {0xAD, 0xAD},       {0x61C, 0x61C},
    {0x180E, 0x180E}, {0x200B, 0x200F}, {0x2028, 0x202E},   {0x2060, 0x206F},
    {0xFEFF, 0xFEFF}, {0xFFF9, 0xFFFB}, {0xE0000, 0xE0FFF},
};

bool IsSeen(std::uint32_t code) {
  return std::none_of(std::begin(kUnseen), std::end(kUnseen), [code](const Range& range) {
    return range.first <= code && code <= range.last;
  });
}

}  // namespace

std::size_t FindInvalidUtf8(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t length = FirstCharacter(text.substr(at)).length;
    if (length == 0) return at;
    at += length;
  }
  return at;
}

std::string PlainText(std::string_view text, std::size_t longest) {
  std::string plain;
  while (!text.empty()) {
    const Character first = FirstCharacter(text);
    if (first.length > 0 && IsSeen(first.code)) {
      if (plain.size() + first.length > longest) break;
      plain.append(text.substr(0, first.length));
    }
    text.remove_prefix(std::max<std::size_t>(first.length, 1));
  }
  return plain;
}

bool LooksLikeUtf16(std::string_view text) {
  if (text.size() < 2) return false;
  const std::string_view start = text.substr(0, 2);
  return start == "\xFF\xFE" || start == "\xFE\xFF" || (text[0] == '\0') != (text[1] == '\0');
}

}  // namespace coppice
