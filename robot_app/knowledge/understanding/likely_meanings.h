// What somebody may want who was heard uncertainly: a recognizer has many texts that he may have
// said, and many of them mean the same. Their chances are added; the texts compete by what they
// mean.
//
//   LikelyMeanings(english, {{"where is the library", 0.4},
//                            {"where is a library", 0.3},
//                            {"were is the lavatory", 0.3}})
//   // find_place library, "where is the library", 0.7; unknown, 0.3
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELY_MEANINGS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELY_MEANINGS_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

/// What may have been said.
struct Alternative {
  std::string text;
  double chance = 0;  ///< beside the others; need not add up to 1
};

struct Meaning {
  Understanding understanding;
  std::string text;  ///< the likeliest of those that mean this
  double share = 0;  ///< its chance, 0..1; those of all meanings add up to 1
  /// The chance on which it may be acted: of several texts one that leaves words unexplained ("take
  /// me to the sun library") has most likely been heard wrong. At most its share.
  double sure = 0;
};

/// A share below which what is meant is asked back: most of what is wrong is below it, and hardly
/// anything that is right (./dev bench speech).
inline constexpr double kSureEnough = 0.85;
/// Likewise of what answers a question: little else is expected.
inline constexpr double kSureReply = 0.65;
/// A share below which nobody is asked about it.
inline constexpr double kWorthAsking = 0.2;
/// Likewise where it is likelier that nothing of it was understood.
inline constexpr double kWorthAskingThough = 0.35;

/// The likeliest first. All that is not understood counts as one meaning. None of no texts.
std::vector<Meaning> LikelyMeanings(const Understander& understander,
                                    const std::vector<Alternative>& alternatives);

/// Whether "did you mean" can be said of it: not of small talk and of what answers questions.
bool CanBeAsked(Intent intent);

/// What is asked for: one request, or one for each choice where a name is ambiguous.
std::vector<Request> RequestsOf(const Understanding& meant);

/// The requests that are to be asked back, the likeliest first: one or two. None if the best
/// meaning is sure enough, or if all are too unlikely.
std::vector<Request> WorthAsking(const std::vector<Meaning>& meanings,
                                 double least_sure = kSureEnough);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LIKELY_MEANINGS_H_
