#include "editor/keys/fuzzy.h"

#include <algorithm>
#include <cctype>

namespace coppice::editor {
namespace {

constexpr int kLetter = 10;
constexpr int kInARow = 15;
constexpr int kWordStart = 20;
constexpr int kLongestText = 200;

char Lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }
bool IsLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

bool StartsWord(std::string_view text, std::size_t at) {
  if (at == 0 || !IsLetter(text[at - 1])) return true;
  return std::isupper(static_cast<unsigned char>(text[at])) &&
         std::islower(static_cast<unsigned char>(text[at - 1]));
}

// Takes for each letter the first place, or (`eager`) rather the next start of a word.
int Score(std::string_view pattern, std::string_view text, bool eager) {
  constexpr std::size_t kNowhere = std::string_view::npos;
  int score = 0;
  std::size_t at = 0;
  std::size_t last = kNowhere;
  for (const char wanted : pattern) {
    if (wanted == ' ') continue;
    std::size_t found = kNowhere;
    for (std::size_t i = at; i < text.size(); ++i) {
      if (Lower(text[i]) != Lower(wanted)) continue;
      if (found == kNowhere) found = i;
      if (!eager || (last != kNowhere && i == last + 1) || StartsWord(text, i)) {
        found = i;
        break;
      }
    }
    if (found == kNowhere) return 0;
    score += kLetter;
    if (last != kNowhere && found == last + 1) score += kInARow;
    if (StartsWord(text, found)) score += kWordStart;
    last = found;
    at = found + 1;
  }
  const int length = std::min<int>(static_cast<int>(text.size()), kLongestText);
  return score * kLongestText - length + kLongestText;
}

}  // namespace

int FuzzyScore(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return 1;
  return std::max(Score(pattern, text, true), Score(pattern, text, false));
}

}  // namespace coppice::editor
