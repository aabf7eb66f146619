#include "robot_app/knowledge/understanding/word_similarity.h"

#include <algorithm>
#include <vector>

namespace coppice::robot::knowledge {
namespace {

constexpr std::size_t kShortest = 4;         // letters of a word that may be misheard
constexpr std::size_t kShortestPart = 5;     // likewise, that may stand for a longer one
constexpr double kLeastForShortSound = 0.7;  // as kLeastForSound, of short words
constexpr double kSoundsAlike = 0.88;
constexpr double kIsBeginning = 0.8;
constexpr double kLeastForSound = 0.45;  // of letters, for words that sound alike

bool HasDigit(std::string_view word) {
  return std::any_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// Codes of one sound are those of too many words.
bool IsSame(const std::string& a, const std::string& b) { return a.size() >= 2 && a == b; }

bool SoundAlike(const SoundingWord& a, const SoundingWord& b) {
  return IsSame(a.german, b.german) || IsSame(a.english.primary, b.english.primary) ||
         IsSame(a.english.primary, b.english.other) || IsSame(a.english.other, b.english.primary);
}

bool IsBeginning(const std::string& part, const std::string& whole) {
  return part.size() >= kShortestPart && 2 * part.size() >= whole.size() &&
         whole.compare(0, part.size(), part) == 0;
}

// How many letters may be wrong, by the length of the shorter word.
int MostWrong(std::size_t length) { return length < 5 ? 0 : length < 8 ? 1 : length < 11 ? 2 : 3; }

}  // namespace

SoundingWord Sounding(std::string word) {
  SoundingWord sounding{std::move(word), {}, {}};
  sounding.german = ColognePhonetics(sounding.text);
  sounding.english = DoubleMetaphone(sounding.text);
  return sounding;
}

int EditDistance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        next[j] = std::min(next[j], before[j - 2] + 1);
      }
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return row[b.size()];
}

double Similarity(const SoundingWord& heard, const SoundingWord& known) {
  const std::string &a = heard.text, &b = known.text;
  if (a == b) return 1;
  const std::size_t shorter = std::min(a.size(), b.size()), longer = std::max(a.size(), b.size());
  if (shorter < kShortest || HasDigit(a) || HasDigit(b) || longer > 2 * shorter) return 0;
  const int distance = EditDistance(a, b);
  const double letters = 1 - static_cast<double>(distance) / static_cast<double>(longer);
  double similarity = distance <= MostWrong(shorter) ? letters : 0;
  const double least = shorter < kShortestPart ? kLeastForShortSound : kLeastForSound;
  if (letters >= least && SoundAlike(heard, known)) {
    similarity = std::max(similarity, kSoundsAlike);
  }
  if (IsBeginning(a, b)) similarity = std::max(similarity, kIsBeginning);
  return similarity;
}

}  // namespace coppice::robot::knowledge
