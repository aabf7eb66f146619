// What somebody has typed or said, taken apart.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UTTERANCE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UTTERANCE_H_

#include <bitset>
#include <string>
#include <string_view>
#include <vector>

#include "robot_app/knowledge/understanding/language_words.h"
#include "robot_app/knowledge/understanding/word_similarity.h"

namespace coppice::robot::knowledge {

/// Of a longer one only the beginning is looked at: nobody asks a robot in more words.
inline constexpr std::size_t kMostWords = 48;

/// Some of the words of an utterance.
using WordSet = std::bitset<kMostWords>;

struct Utterance {
  std::vector<SoundingWord> words;   ///< folded; letters and digits are words of their own
  std::vector<SoundingWord> joined;  ///< each with the one behind it; one less
  WordSet content;                   ///< words that are no fillers
  WordSet exact;                     ///< known words: they are not misspelt ones
};

/// Splits "S3" into "s" and "3".
std::vector<std::string> SplitWords(std::string_view text);
/// Likewise, with contractions written out. Names are split in the same way.
std::vector<std::string> SplitWords(std::string_view text, const LanguageWords& language);

/// Numbers that are written out become digits: "one oh three" is "103", "line four" is "line 4".
Utterance TakeApart(std::string_view text, const LanguageWords& language);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_UTTERANCE_H_
