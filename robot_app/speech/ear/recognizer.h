// Speech to text offline, by pocketsphinx with the acoustic model of Debian's pocketsphinx-en-us.
// There is no German one.
//
//   auto recognizer = Recognizer::Make(kModelFolder, {table, words, Names(database), kEnglish});
//   (*recognizer)->Recognize(utterance).front().text   // "where is room 101"
//
// What is listened for is made from the knowledge (spoken_sentences.h), and beside it the common
// words of the language: who says something else is to be refused by the understanding, not to be
// bent into something that he has not said. To make one takes about a second; a new import of the
// knowledge needs a new one. For one thread at a time.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/understanding/likeliest_meaning.h"
#include "robot_app/speech/ear/spoken_sentences.h"
#include "robot_app/speech/sound/sound.h"

struct ps_decoder_s;

namespace coppice::robot::speech {

inline constexpr char kEnglishModel[] = "/usr/share/pocketsphinx/model/en-us";

/// How much the recognizer leans on what it expects to hear.
struct Expectation {
  double language_weight = 6.5;  ///< of the words against the sound
  double surprise = 0.03;        ///< share of words that were not expected after those before
  double anything = 0.2;  ///< of these, the share of words that the knowledge knows nothing of
  std::size_t common_words = 1000;
};

class Recognizer {
 public:
  static Expected<std::unique_ptr<Recognizer>> Make(const std::string& model_folder,
                                                    const SpokenLanguage& spoken,
                                                    const Expectation& expectation = {});

  /// What may have been said in a whole utterance of any rate, with a little silence around it: up
  /// to a hundred texts of folded words, the likeliest first; none: nothing was recognized. Which
  /// words were said is seldom certain, what was meant by them more often (likeliest_meaning.h).
  std::vector<knowledge::Alternative> Recognize(const Sound& sound);

 private:
  struct Free {
    void operator()(ps_decoder_s* decoder) const;
  };
  explicit Recognizer(ps_decoder_s* decoder) : decoder_(decoder) {}

  std::unique_ptr<ps_decoder_s, Free> decoder_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_RECOGNIZER_H_
