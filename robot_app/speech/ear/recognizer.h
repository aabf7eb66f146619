// Speech to text offline, by pocketsphinx with the acoustic model of Debian's pocketsphinx-en-us.
// There is no German one.
//
//   auto recognizer = Recognizer::Make(kModelFolder, {table, words, Names(database), kEnglish});
//   (*recognizer)->Recognize(utterance).front().text   // "where is room 101"
//
// What is listened for is made from the knowledge (spoken_sentences.h), and beside it the common
// words of the language: who says something else is to be refused by the understanding, not to be
// bent into something that he has not said. Two decoders listen, on a thread each: one that expects
// little but what is asked here, and one that knows what is said anywhere. What both have heard
// counts twice. To make them takes a few seconds; a new import of the knowledge needs new ones. For
// one thread at a time.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/understanding/likely_meanings.h"
#include "robot_app/speech/ear/decoder.h"
#include "robot_app/speech/ear/spoken_sentences.h"
#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

inline constexpr char kEnglishModel[] = "/usr/share/pocketsphinx/model/en-us";

class Recognizer {
 public:
  static Expected<std::unique_ptr<Recognizer>> Make(const std::string& model_folder,
                                                    const SpokenLanguage& spoken);

  /// What may have been said in a whole utterance of any rate, with a little silence around it: up
  /// to two hundred texts of folded words, the likeliest first; none: nothing was recognized. Which
  /// words were said is seldom certain, what was meant by them more often (likely_meanings.h).
  std::vector<knowledge::Alternative> Recognize(const Sound& sound);

  /// Likewise of somebody who was asked something back: yes, no, a number or one of the names. None
  /// if he has said something else.
  std::vector<knowledge::Alternative> RecognizeReply(const Sound& sound,
                                                     const std::vector<std::string>& names);

 private:
  Recognizer() = default;
  void SetReplies(const NgramCounts& common, const SpokenLanguage& spoken);
  void ExpectReply(const std::vector<std::string>& names);

  std::vector<Decoder> decoders_;  // two
  NgramCounts replies_;            // without names
  std::set<std::string> words_of_replies_;
  bool expects_reply_ = false;      // has a model of what may be replied
  std::vector<std::string> names_;  // in that, and
  std::set<std::string> words_;     // all of its words
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_
