#include "editor/keys/fuzzy.h"

#include <algorithm>
#include <cctype>

namespace coppice::editor {
namespace {

constexpr int kLetter = 10;
constexpr int kInARow = 15;
constexpr int kWordStart = 20;
constexpr int kLongestText = 200;
constexpr int kFit = 10 * kSameFit;

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

bool BeginsAt(std::string_view pattern, std::string_view text, std::size_t at) {
  if (at + pattern.size() > text.size()) return false;
  return std::equal(pattern.begin(), pattern.end(), text.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, char b) { return Lower(a) == Lower(b); });
}

bool EndsWord(std::string_view text, std::size_t end) {
  return end == text.size() || !IsLetter(text[end]) || StartsWord(text, end);
}

// From 0, some letters, to 4, the whole text.
int FitOf(std::string_view pattern, std::string_view text) {
  int best = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (!StartsWord(text, at) || !BeginsAt(pattern, text, at)) continue;
    const std::size_t end = at + pattern.size();
    const bool is_word = EndsWord(text, end);
    if (at == 0 && end == text.size()) return 4;
    best = std::max(best, is_word ? 3 : at == 0 ? 2 : 1);
  }
  return best;
}

}  // namespace

int FuzzyScore(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return 1;
  const int score = std::max(Score(pattern, text, true), Score(pattern, text, false));
  if (score == 0) return 0;
  return (1 + FitOf(pattern, text)) * kFit + std::min(score, kSameFit - 1);
}

}  // namespace coppice::editor
