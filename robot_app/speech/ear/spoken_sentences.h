// What people may say to the robot, as sentences with a weight: the examples and phrases of the
// table of intents (knowledge/language/intents.yaml) with all names that fit into them. A language
// model is made from them (ngram_model.h).
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_SPOKEN_SENTENCES_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_SPOKEN_SENTENCES_H_

#include <functional>
#include <string>
#include <vector>

#include "robot_app/knowledge/understanding/intent_table.h"
#include "robot_app/knowledge/understanding/language_words.h"

namespace coppice::robot::speech {

/// Folded words.
using Sentence = std::vector<std::string>;

std::vector<Sentence> AsSentences(const std::vector<std::string>& texts);

struct SpokenLanguage {
  const knowledge::IntentTable& intents;
  const knowledge::LanguageWords& words;
  const std::vector<knowledge::Name>& names;
  knowledge::Language language = knowledge::Language::kEnglish;
};

/// Calls `add` for each sentence; the weights of a phrase with all its names add up to about 1. Of
/// many names (2 000 and more of a kind) each phrase takes some in turn.
void ForEachSentence(const SpokenLanguage& spoken,
                     const std::function<void(const Sentence& sentence, double weight)>& add);

/// Likewise what people say to a question back: yes, no, "the first one"; and one of the names.
void ForEachReply(const SpokenLanguage& spoken,
                  const std::function<void(const Sentence& sentence, double weight)>& add);
void ForEachNamed(const std::vector<std::string>& names,
                  const std::function<void(const Sentence& sentence, double weight)>& add);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_SPOKEN_SENTENCES_H_
