// How much of what people say is understood: utterances written by hand, each with what it means. A
// third of them is held out: never looked at while phrases and thresholds were chosen.
#ifndef COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_FIGURES_H_
#define COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_FIGURES_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

/// A row of utterances.LANGUAGE.csv. `intent` is "none" where nothing can be answered; `slots` are
/// "place=library;day=sunday". "person=a|b" has to be asked back.
struct SpokenExample {
  std::string text, intent, slots;
  bool is_held_out = false;
};
std::vector<SpokenExample> LoadExamples(const std::string& path);
std::string UtterancesFile(Language language);

/// What became of an example.
enum class Hearing {
  kRight,        ///< intent and slots; or refused, or asked back, where that is right
  kAsked,        ///< asked back, the right one among the choices
  kRefused,      ///< although it can be answered
  kWrongChoice,  ///< asked back without the right one among the choices
  kWrongAction,  ///< something else was understood
};
Hearing HearingOf(const Understanding& heard, const SpokenExample& example);
/// "find_place place=library", for reports.
std::string TextOf(const Understanding& heard);

struct HearingCounts {
  int answerable = 0, unanswerable = 0;
  int right = 0;    ///< of the answerable ones
  int refused = 0;  ///< of the unanswerable ones
  int asked = 0, wrong_actions = 0;

  void Add(const SpokenExample& example, Hearing hearing);
  double right_share() const { return static_cast<double>(right) / answerable; }
  double refused_share() const { return static_cast<double>(refused) / unanswerable; }
  double wrong_share() const {
    return static_cast<double>(wrong_actions) / (answerable + unanswerable);
  }
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_FIGURES_H_
