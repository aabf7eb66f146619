#include "robot_app/speech/ear/common_words.h"

#include <pocketsphinx.h>
#include <sphinxbase/err.h>

#include <algorithm>
#include <memory>

#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::speech {
namespace {

constexpr double kLogBase = 1.0001;

struct FreeLogs {
  void operator()(logmath_t* logs) const { logmath_free(logs); }
};
struct FreeModel {
  void operator()(ngram_model_t* model) const { ngram_model_free(model); }
};

}  // namespace

Expected<std::vector<std::pair<std::string, double>>> CommonWords(const std::string& path,
                                                                  std::size_t most) {
  err_set_logfp(nullptr);
  const std::unique_ptr<logmath_t, FreeLogs> logs(logmath_init(kLogBase, 0, 1));
  const std::unique_ptr<ngram_model_t, FreeModel> model(
      ngram_model_read(nullptr, path.c_str(), NGRAM_AUTO, logs.get()));
  if (!model) return Problem{"cannot read the language model " + path};
  std::vector<std::pair<std::string, double>> words;
  const auto count = static_cast<int32>(ngram_model_get_counts(model.get())[0]);
  for (int32 id = 0; id < count; ++id) {
    const char* const word = ngram_word(model.get(), id);
    if (word == nullptr || word[0] == '<') continue;
    int32 used = 0;
    const int32 log = ngram_ng_prob(model.get(), id, nullptr, 0, &used);
    words.emplace_back(knowledge::Folded(word), logmath_exp(logs.get(), log));
  }
  std::sort(words.begin(), words.end(),
            [](const auto& a, const auto& b) { return a.second > b.second; });
  if (words.size() > most) words.resize(most);
  return words;
}

}  // namespace coppice::robot::speech
