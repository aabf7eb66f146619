#include "robot_app/speech/ear/recognizer.h"

#include <pocketsphinx.h>
#include <sphinxbase/err.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "robot_app/speech/ear/common_words.h"
#include "robot_app/speech/ear/ngram_counts.h"
#include "robot_app/speech/ear/pronunciations.h"

namespace coppice::robot::speech {
namespace {

constexpr int kMostPaths = 100;  // that the words may have taken

// Scores of paths, in the decoder's units, that are that much apart have chances of 1 : e. As it
// counts every frame as a witness of its own it would be far too sure; found by the bench.
constexpr double kBlur = 0.02;
// Its own choice, which it has looked for more thoroughly, has half the say of all paths together.
constexpr double kSayOfChoice = 0.5;

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

void AddChoice(const char* choice, std::vector<knowledge::Alternative>& alternatives) {
  double all = 0;
  for (const auto& alternative : alternatives) all += alternative.chance;
  const double say = alternatives.empty() ? 1 : kSayOfChoice * all;
  const auto same = std::find_if(alternatives.begin(), alternatives.end(),
                                 [&](const auto& one) { return one.text == choice; });
  if (same == alternatives.end()) {
    alternatives.push_back({choice, say});
  } else {
    same->chance += say;
  }
}

// What may have been said, the likeliest first, each text once.
std::vector<knowledge::Alternative> AlternativesOf(ps_decoder_t* decoder, const char* choice) {
  std::vector<knowledge::Alternative> alternatives;
  std::set<std::string> texts;
  double best = 0;
  int paths = 0;
  ps_nbest_t* path = ps_nbest(decoder);
  for (; path != nullptr && paths < kMostPaths; path = ps_nbest_next(path), ++paths) {
    int32 log_score = 0;
    const char* const text = ps_nbest_hyp(path, &log_score);
    if (text == nullptr || !texts.insert(text).second) continue;
    const double score = logmath_log_to_ln(ps_get_logmath(decoder), log_score);
    if (alternatives.empty()) best = score;
    alternatives.push_back({text, std::exp((score - best) / kBlur)});
  }
  if (path != nullptr) ps_nbest_free(path);
  AddChoice(choice, alternatives);
  std::stable_sort(alternatives.begin(), alternatives.end(),
                   [](const auto& a, const auto& b) { return a.chance > b.chance; });
  return alternatives;
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

std::vector<knowledge::Alternative> Recognizer::Recognize(const Sound& sound) {
  const Sound heard = Resampled(sound, kHearingRate);
  if (heard.samples.empty() || ps_start_utt(decoder_.get()) < 0) return {};
  ps_process_raw(decoder_.get(), heard.samples.data(), heard.samples.size(), FALSE, TRUE);
  ps_end_utt(decoder_.get());
  const char* const found = ps_get_hyp(decoder_.get(), nullptr);
  if (found == nullptr) return {};
  const std::string choice = found;  // it is gone when paths are looked for
  return AlternativesOf(decoder_.get(), choice.c_str());
}

}  // namespace coppice::robot::speech
