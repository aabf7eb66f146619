// Text to speech offline, by libespeak-ng.
//
//   Synthesizer voice;
//   const Expected<Speech> speech = voice.Speak("Where to?", {"en-us", 160});
//   speech->words[1]                                           // "to": begins 9 bytes ... after
//
// espeak-ng has one state in each process: all objects of this class share it, and calls wait for
// each other. Ten to a hundred times faster than the speech. Any thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_MOUTH_SYNTHESIZER_H_
#define COPPICE_ROBOT_APP_SPEECH_MOUTH_SYNTHESIZER_H_

#include <cstddef>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/speech/sound/sound.h"

namespace coppice::robot::speech {

/// When a word begins in the sound, and where it stands in the text [bytes].
struct SpokenWord {
  double second = 0;
  std::size_t begin = 0, length = 0;
};

struct Speech {
  Sound sound;
  std::vector<SpokenWord> words;  ///< in their order; of an endpoint none
};

struct Voice {
  std::string name = "en-us";  ///< of `espeak-ng --voices`; "en-us+f3" is a variant of it
  int words_per_minute = 160;
};

class Synthesizer {
 public:
  /// Throws std::runtime_error if espeak-ng has no data.
  Synthesizer();

  /// Of a text in UTF-8; markup is read out, not obeyed. A problem if there is no such voice.
  Expected<Speech> Speak(const std::string& text, const Voice& voice) const;

  /// How a voice says a word, in the International Phonetic Alphabet: one phoneme each.
  std::vector<std::string> Phonemes(const std::string& word, const std::string& voice) const;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_MOUTH_SYNTHESIZER_H_
