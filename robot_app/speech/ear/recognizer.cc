#include "robot_app/speech/ear/recognizer.h"

#include <pocketsphinx.h>
#include <sphinxbase/err.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "robot_app/speech/ear/common_words.h"
#include "robot_app/speech/ear/ngram_counts.h"
#include "robot_app/speech/ear/pronunciations.h"

namespace coppice::robot::speech {
namespace {

constexpr double kCommonShare = 0.6;  // of what may come anywhere; the rest are fillers

// A folder for files that are read once.
class Folder {
 public:
  Folder() {
    std::string path = (std::filesystem::temp_directory_path() / "coppice-ear-XXXXXX").string();
    if (mkdtemp(path.data()) != nullptr) path_ = path;
  }
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string Path(const std::string& name) const { return path_ + "/" + name; }

 private:
  std::string path_;
};

Outcome AddCommonWords(const std::string& folder, const SpokenLanguage& spoken, std::size_t most,
                       const Pronunciations& dictionary, NgramCounts& counts) {
  auto words = CommonWords(folder + "/en-us.lm.bin", most);
  if (!words) return Problem{words.problem()};
  double sum = 0;
  for (auto& [word, probability] : *words) {
    if (!dictionary.Knows(word)) probability = 0;
    sum += probability;
  }
  for (const auto& [word, probability] : *words) {
    if (probability > 0) counts.AddAnywhere(word, kCommonShare * probability / sum);
  }
  const auto fillers = static_cast<double>(spoken.words.fillers.size());
  for (const std::string& filler : spoken.words.fillers) {
    counts.AddAnywhere(filler, (1 - kCommonShare) / fillers);
  }
  return {};
}

void WriteDictionary(const std::string& path, const NgramCounts& counts,
                     const Pronunciations& dictionary) {
  std::ofstream file(path);
  for (const std::string& word : counts.Words()) {
    if (word[0] == '<') continue;
    int number = 0;
    for (const std::string& spoken : dictionary.Of(word)) {
      file << word;
      if (++number > 1) file << "(" << number << ")";
      file << " " << spoken << "\n";
    }
  }
}

ps_decoder_t* Decoder(const std::string& model, const Folder& files, double language_weight) {
  const std::string weight = std::to_string(language_weight);
  const std::string last_weight = std::to_string(1.5 * language_weight);
  cmd_ln_t* const config =
      cmd_ln_init(nullptr, ps_args(), TRUE, "-hmm", (model + "/en-us").c_str(), "-dict",
                  files.Path("words.dict").c_str(), "-lm", files.Path("site.arpa").c_str(), "-lw",
                  weight.c_str(), "-fwdflatlw", weight.c_str(), "-bestpathlw", last_weight.c_str(),
                  "-logfn", "/dev/null", nullptr);
  ps_decoder_t* const decoder = config == nullptr ? nullptr : ps_init(config);
  if (config != nullptr) cmd_ln_free_r(config);
  return decoder;
}

// The mean posterior probability of the words.
double ConfidenceOf(ps_decoder_t* decoder) {
  double sum = 0;
  int words = 0;
  for (ps_seg_t* word = ps_seg_iter(decoder); word != nullptr; word = ps_seg_next(word)) {
    if (std::strchr("<[+", ps_seg_word(word)[0]) != nullptr) continue;  // silence and noises
    const int32 log = ps_seg_prob(word, nullptr, nullptr, nullptr);
    sum += logmath_exp(ps_get_logmath(decoder), log);
    ++words;
  }
  return words == 0 ? 0 : sum / words;
}

}  // namespace

void Recognizer::Free::operator()(ps_decoder_s* decoder) const { ps_free(decoder); }

Expected<std::unique_ptr<Recognizer>> Recognizer::Make(const std::string& model_folder,
                                                       const SpokenLanguage& spoken,
                                                       const Expectation& expectation) {
  err_set_logfp(nullptr);
  const auto dictionary = Pronunciations::Load(model_folder + "/cmudict-en-us.dict");
  if (!dictionary) return Problem{dictionary.problem()};
  NgramCounts counts;
  counts.lower = expectation.surprise;
  counts.anywhere = expectation.anything;
  ForEachSentence(
      spoken, [&counts](const Sentence& sentence, double weight) { counts.Add(sentence, weight); });
  const Outcome added =
      AddCommonWords(model_folder, spoken, expectation.common_words, *dictionary, counts);
  if (!added) return Problem{added.problem()};
  const Folder files;
  std::ofstream(files.Path("site.arpa")) << counts.Arpa();
  WriteDictionary(files.Path("words.dict"), counts, *dictionary);
  ps_decoder_t* const decoder = Decoder(model_folder, files, expectation.language_weight);
  if (decoder == nullptr) return Problem{"pocketsphinx cannot read the model " + model_folder};
  return std::unique_ptr<Recognizer>(new Recognizer(decoder));
}

Recognition Recognizer::Recognize(const Sound& sound) {
  const Sound heard = Resampled(sound, kHearingRate);
  if (heard.samples.empty() || ps_start_utt(decoder_.get()) < 0) return {};
  ps_process_raw(decoder_.get(), heard.samples.data(), heard.samples.size(), FALSE, TRUE);
  ps_end_utt(decoder_.get());
  const char* const text = ps_get_hyp(decoder_.get(), nullptr);
  if (text == nullptr) return {};
  return {text, ConfidenceOf(decoder_.get())};
}

}  // namespace coppice::robot::speech
