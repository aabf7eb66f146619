// How much a word that was typed or heard is like one that is known.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_WORD_SIMILARITY_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_WORD_SIMILARITY_H_

#include <string>
#include <string_view>

#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/understanding/phonetics.h"

namespace coppice::robot::knowledge {

/// A folded word and how it sounds in each language.
struct SoundingWord {
  std::string text;
  std::string german;
  MetaphoneCodes english;
};
SoundingWord Sounding(std::string word);

/// How many letters must be inserted, removed, replaced or swapped with their neighbour to make one
/// of the other (optimal string alignment).
int EditDistance(std::string_view a, std::string_view b);

/// From 0 to 1, the same word. Words with digits and words of less than four letters are the same
/// or not alike at all. A beginning of at least five letters is like the whole.
double Similarity(const SoundingWord& heard, const SoundingWord& known);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_WORD_SIMILARITY_H_
