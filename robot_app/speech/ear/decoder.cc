#include "robot_app/speech/ear/decoder.h"

#include <pocketsphinx.h>
#include <sphinxbase/err.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace coppice::robot::speech {
namespace {

constexpr int kMostPaths = 100;  // that the words may have taken

// Scores of paths, in the decoder's units, that are that much apart have chances of 1 : e. As it
// counts every frame as a witness of its own it would be far too sure; found by the bench.
constexpr double kBlur = 0.02;
// Its own choice, which it has looked for more thoroughly, has half the say of all paths together.
constexpr double kSayOfChoice = 0.5;

constexpr char kSentences[] = "sentences", kReplies[] = "replies";  // searches

// A folder for files that are read once: where temporary files are, or in memory if there is no
// room. The library crashes at a model that was written in part.
class Folder {
 public:
  using Files = std::vector<std::pair<std::string, std::string>>;  // name, content

  explicit Folder(const Files& files) {
    std::error_code error;
    for (const std::filesystem::path& base :
         {std::filesystem::temp_directory_path(error), std::filesystem::path("/dev/shm")}) {
      Remove();
      is_whole_ = !base.empty() && Fill(base, files);
      if (is_whole_) return;
    }
  }
  ~Folder() { Remove(); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string Path(const std::string& name) const { return path_ + "/" + name; }
  bool is_whole() const { return is_whole_; }

 private:
  bool Fill(const std::filesystem::path& base, const Files& files) {
    std::string path = (base / "coppice-ear-XXXXXX").string();
    if (mkdtemp(path.data()) == nullptr) return false;
    path_ = path;
    return std::all_of(files.begin(), files.end(), [this](const auto& file) {
      std::ofstream stream(Path(file.first), std::ios::binary);
      stream << file.second;
      stream.close();
      return stream.good();
    });
  }
  void Remove() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
    path_.clear();
  }

  std::string path_;
  bool is_whole_ = false;
};

std::string DictionaryOf(const NgramCounts& counts, const Pronunciations& dictionary) {
  std::ostringstream file;
  for (const std::string& word : counts.Words()) {
    if (word[0] == '<') continue;
    int number = 0;
    for (const std::string& spoken : dictionary.Of(word)) {
      file << word;
      if (++number > 1) file << "(" << number << ")";
      file << " " << spoken << "\n";
    }
  }
  return file.str();
}

// Noise and silence have been taken out already.
ps_decoder_t* DecoderOf(const std::string& model, const Folder& files, double language_weight) {
  const std::string weight = std::to_string(language_weight);
  const std::string last_weight = std::to_string(1.5 * language_weight);
  cmd_ln_t* const config =
      cmd_ln_init(nullptr, ps_args(), TRUE, "-hmm", (model + "/en-us").c_str(), "-dict",
                  files.Path("words.dict").c_str(), "-lw", weight.c_str(), "-fwdflatlw",
                  weight.c_str(), "-bestpathlw", last_weight.c_str(), "-remove_noise", "no",
                  "-remove_silence", "no", "-logfn", "/dev/null", nullptr);
  ps_decoder_t* const decoder = config == nullptr ? nullptr : ps_init(config);
  if (config != nullptr) cmd_ln_free_r(config);
  return decoder;
}

// The library counts who refers to a model: whoever is given it beside us keeps it for himself.
struct FreeModel {
  void operator()(ngram_model_t* model) const { ngram_model_free(model); }
};
using Model = std::unique_ptr<ngram_model_t, FreeModel>;

Model ReadModel(ps_decoder_t* decoder, const std::string& path) {
  return Model(
      ngram_model_read(ps_get_config(decoder), path.c_str(), NGRAM_AUTO, ps_get_logmath(decoder)));
}

// Sentences of the site, and a share of any others. The library adds probabilities when they have
// been raised to the power of the language weight already, so the share is, too.
bool SetSentences(ps_decoder_t* decoder, const std::string& site, const std::string& general,
                  const Expectation& expectation) {
  const Model of_site = ReadModel(decoder, site);
  if (of_site == nullptr) return false;
  Model both;
  if (expectation.elsewhere > 0) {
    const Model of_any = ReadModel(decoder, general);
    if (of_any == nullptr) return false;
    std::string first = "site", second = "general";
    std::array<char*, 2> names = {first.data(), second.data()};
    std::array<ngram_model_t*, 2> models = {of_site.get(), of_any.get()};
    const double power = expectation.language_weight;
    const std::array<float32, 2> weights = {
        static_cast<float32>(std::pow(1 - expectation.elsewhere, power)),
        static_cast<float32>(std::pow(expectation.elsewhere, power))};
    both.reset(ngram_model_set_init(ps_get_config(decoder), models.data(), names.data(),
                                    weights.data(), 2));
    if (both == nullptr) return false;
  }
  return ps_set_lm(decoder, kSentences, both != nullptr ? both.get() : of_site.get()) == 0;
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
  double sum = 0;
  for (const auto& alternative : alternatives) sum += alternative.chance;
  for (auto& alternative : alternatives) alternative.chance /= sum;
  std::stable_sort(alternatives.begin(), alternatives.end(),
                   [](const auto& a, const auto& b) { return a.chance > b.chance; });
  return alternatives;
}

}  // namespace

void Decoder::Free::operator()(ps_decoder_s* decoder) const { ps_free(decoder); }

Expected<Decoder> Decoder::Make(const std::string& model_folder, const Pronunciations& dictionary,
                                const NgramCounts& site, const Expectation& expectation) {
  err_set_logfp(nullptr);
  Folder::Files texts;  // long ones
  texts.emplace_back("site.arpa", site.Arpa());
  texts.emplace_back("words.dict", DictionaryOf(site, dictionary));
  const Folder files(std::exchange(texts, {}));
  if (!files.is_whole()) return Problem{"there is no room for the words of the site"};
  Decoder made(DecoderOf(model_folder, files, expectation.language_weight));
  if (!made.decoder_ || !SetSentences(made.decoder_.get(), files.Path("site.arpa"),
                                      model_folder + "/en-us.lm.bin", expectation)) {
    return Problem{"pocketsphinx cannot read the model " + model_folder};
  }
  return made;
}

void Decoder::SetReplies(const NgramCounts& replies) {
  const Folder files({{"replies.arpa", replies.Arpa()}});
  if (!files.is_whole()) return;
  const Model model = ReadModel(decoder_.get(), files.Path("replies.arpa"));
  if (model != nullptr) ps_set_lm(decoder_.get(), kReplies, model.get());
}

std::vector<knowledge::Alternative> Decoder::Recognize(const Sound& sound) {
  return RecognizeWith(kSentences, sound);
}

std::vector<knowledge::Alternative> Decoder::RecognizeReply(const Sound& sound) {
  return RecognizeWith(kReplies, sound);
}

std::vector<knowledge::Alternative> Decoder::RecognizeWith(const char* search, const Sound& sound) {
  const Sound heard = Resampled(sound, kHearingRate);
  if (heard.samples.empty() || ps_set_search(decoder_.get(), search) < 0) return {};
  if (ps_start_utt(decoder_.get()) < 0) return {};
  ps_process_raw(decoder_.get(), heard.samples.data(), heard.samples.size(), FALSE, TRUE);
  ps_end_utt(decoder_.get());
  const char* const found = ps_get_hyp(decoder_.get(), nullptr);
  if (found == nullptr) return {};
  const std::string choice = found;  // it is gone when paths are looked for
  return AlternativesOf(decoder_.get(), choice.c_str());
}

}  // namespace coppice::robot::speech
