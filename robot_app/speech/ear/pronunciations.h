// How words are spoken, in the phonemes of the acoustic model (ARPAbet, as CMUdict writes it).
//
//   const auto dictionary = Pronunciations::Load("cmudict-en-us.dict");
//   dictionary->Of("101")      // "W AH N OW W AH N", "W AH N HH AH N D R AH D ..." ...
//   dictionary->Of("yilmaz")   // as espeak-ng would read it, in English and in German
//
// Words are folded (knowledge/store/folded_text.h): "whats" is "what's". Any thread.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_PRONUNCIATIONS_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_PRONUNCIATIONS_H_

#include <string>
#include <unordered_map>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/speech/mouth/synthesizer.h"

namespace coppice::robot::speech {

class Pronunciations {
 public:
  static Expected<Pronunciations> Load(const std::string& path);

  /// All ways to say it, the usual one first. Digits are said one by one or as a number.
  std::vector<std::string> Of(const std::string& word) const;
  bool Knows(const std::string& word) const { return words_.count(word) > 0; }

 private:
  std::vector<std::string> OfWord(const std::string& word) const;
  std::vector<std::string> OfNumber(const std::string& digits) const;

  Synthesizer reader_;  // of words that are not in the file
  std::unordered_map<std::string, std::vector<std::string>> words_;
};

/// The nearest phonemes of English to one of the International Phonetic Alphabet as espeak-ng
/// writes it: "R" to "ɹ", "K" to "ç", "AA R" to "ɑːɹ". Empty if it is silent.
std::string ArpabetOf(const std::string& ipa);

/// The words for a number of up to four digits: {"one oh three", "one zero three", "one hundred
/// three", "one hundred and three"}.
std::vector<std::vector<std::string>> SpokenNumber(const std::string& digits);

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_PRONUNCIATIONS_H_
