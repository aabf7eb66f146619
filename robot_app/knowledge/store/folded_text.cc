#include "robot_app/knowledge/store/folded_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>

namespace coppice::robot::knowledge {
namespace {

// U+00C0 to U+00FF (Latin-1 Supplement), as they are written without accents. A capital and its
// small letter are 32 apart.
constexpr std::array<const char*, 32> kLatin = {
    "a", "a", "a", "a", "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",
    "d", "n", "o", "o", "o",  "o", "oe", " ", "o", "u", "u", "u", "ue", "y", "th", "ss"};

// U+0100 to U+017F (Latin Extended-A), likewise.
constexpr std::string_view kExtended =
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkkllllllllllnnnnnnnnn"
    "oooooooorrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
static_assert(kExtended.size() == 128);

struct Character {
  std::uint32_t code = 0;
  std::size_t length = 0;  // bytes; 0: these are no UTF-8
};

Character FirstCharacter(std::string_view text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xF0 && lead < 0xF5   ? 4
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                                                           : 0;
  if (length == 0 || text.size() < length) return {};
  std::uint32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = (code << 6) | (byte(i) & 0x3FU);
  }
  return {code, length};
}

bool IsApostrophe(std::uint32_t code) { return code == '\'' || code == 0x2019 || code == '`'; }

std::string FoldedCharacter(std::uint32_t code) {
  if (code >= 'A' && code <= 'Z') return {static_cast<char>(code - 'A' + 'a')};
  if ((code >= 'a' && code <= 'z') || (code >= '0' && code <= '9')) {
    return {static_cast<char>(code)};
  }
  if (code == 0xDF) return "ss";
  if (code >= 0xC0 && code <= 0xFF) return kLatin[(code - 0xC0) % 32];
  if (code >= 0x100 && code <= 0x17F) return {kExtended[code - 0x100]};
  return " ";
}

}  // namespace

std::string Folded(std::string_view text) {
  std::string folded;
  while (!text.empty()) {
    const Character character = FirstCharacter(text);
    text.remove_prefix(std::max<std::size_t>(character.length, 1));
    if (IsApostrophe(character.code)) continue;
    const std::string letters = FoldedCharacter(character.code);
    if (letters != " " || (!folded.empty() && folded.back() != ' ')) folded += letters;
  }
  if (!folded.empty() && folded.back() == ' ') folded.pop_back();
  return folded;
}

std::vector<std::string> Words(std::string_view text) {
  std::istringstream stream(Folded(text));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace coppice::robot::knowledge
