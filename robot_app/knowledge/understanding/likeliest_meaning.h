// What somebody wants who was heard uncertainly: a recognizer has many texts that he may have said,
// and many of them mean the same. Their chances are added; the texts compete by what they mean.
//
//   LikeliestMeaning(english, {{"where is the library", 0.4},
//                              {"where is a library", 0.3},
//                              {"were is the lavatory", 0.3}})
//   // "where is the library", 0.7
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELIEST_MEANING_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELIEST_MEANING_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

/// What may have been said.
struct Alternative {
  std::string text;
  double chance = 0;  ///< beside the others; need not add up to 1
};

struct LikelyText {
  std::string text;  ///< the likeliest of those with the likeliest meaning
  double share = 0;  ///< chance of that meaning, 0..1
};

/// All that is not understood counts as one meaning. Without alternatives the text is empty.
LikelyText LikeliestMeaning(const Understander& understander,
                            const std::vector<Alternative>& alternatives);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELIEST_MEANING_H_
