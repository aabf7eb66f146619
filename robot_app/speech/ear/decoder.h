// A decoder of pocketsphinx with a model of what people say here, and with one of what they say
// anywhere: from sound to the texts that may have been said.
//
//   auto decoder = Decoder::Make(kEnglishModel, dictionary, counts_of_sentences, {});
//   decoder->Recognize(sound)   // {{"where is room 101", 0.9}, {"wheres room 101", 0.4}, ...}
//
// For one thread at a time.
#ifndef COPPICE_ROBOT_APP_SPEECH_EAR_DECODER_H_
#define COPPICE_ROBOT_APP_SPEECH_EAR_DECODER_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/understanding/likely_meanings.h"
#include "robot_app/speech/ear/ngram_counts.h"
#include "robot_app/speech/ear/pronunciations.h"
#include "robot_app/speech/sound/sound.h"

struct ps_decoder_s;

namespace coppice::robot::speech {

/// How much a decoder leans on what it expects to hear.
struct Expectation {
  double language_weight = 8;  ///< of the words against the sound
  double surprise = 0.03;      ///< share of words that were not expected after those before
  double anything = 0.2;       ///< of these, the share of words that the knowledge knows nothing of
  std::size_t common_words = 1000;
  double elsewhere = 0;  ///< share of sentences as people say them anywhere (Debian's model)
};

class Decoder {
 public:
  /// `site`: what people say here; all of its words are in the dictionary of the decoder.
  static Expected<Decoder> Make(const std::string& model_folder, const Pronunciations& dictionary,
                                const NgramCounts& site, const Expectation& expectation);

  /// The texts that may have been said, the likeliest first, with chances that add up to 1. At most
  /// a hundred and one. No noise is to be in the sound.
  std::vector<knowledge::Alternative> Recognize(const Sound& sound);

  /// What people say to a question back. Without room for temporary files it stays what it was.
  void SetReplies(const NgramCounts& replies);
  /// Likewise with these alone.
  std::vector<knowledge::Alternative> RecognizeReply(const Sound& sound);

 private:
  struct Free {
    void operator()(ps_decoder_s* decoder) const;
  };
  explicit Decoder(ps_decoder_s* decoder) : decoder_(decoder) {}
  std::vector<knowledge::Alternative> RecognizeWith(const char* search, const Sound& sound);

  std::unique_ptr<ps_decoder_s, Free> decoder_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_EAR_DECODER_H_
