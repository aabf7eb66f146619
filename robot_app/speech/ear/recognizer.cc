#include "robot_app/speech/ear/recognizer.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <thread>

#include "robot_app/knowledge/understanding/utterance.h"
#include "robot_app/speech/ear/common_words.h"
#include "robot_app/speech/ear/noise_reduction.h"

namespace coppice::robot::speech {
namespace {

constexpr int kLoudEnough = 30;                  // of 32767; less is silence
constexpr double kLeastReply = 0.6;              // else it was no reply
constexpr double kUnasked = 0.2;                 // of the weight of replies, while nothing is asked
constexpr double kGreeted = 0.1, kPolite = 0.1;  // said with "excuse me", with "please"
constexpr double kCommonShare = 0.6;             // of what may come anywhere; the rest are fillers
constexpr double kLeastChance = 1e-3;            // of a text that is worth being understood

// One knows little but what people ask here, the other what they say anywhere, too: what only one
// of them has understood is less sure.
const Expectation kStrict{8, 0.03, 0.2, 1000, 0};
const Expectation kOpen{8, 0.01, 0.1, 2000, 0.1};

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

NgramCounts CountsOf(const SpokenLanguage& spoken) {
  NgramCounts counts;
  ForEachSentence(
      spoken, [&counts](const Sentence& sentence, double weight) { counts.Add(sentence, weight); });
  counts.AddBefore(AsSentences(spoken.words.greetings), kGreeted);
  counts.AddBehind(AsSentences(spoken.words.courtesies), kPolite);
  ForEachReply(spoken, [&counts](const Sentence& sentence, double weight) {
    counts.Add(sentence, kUnasked * weight);
  });
  return counts;
}

// What both have heard, each with half the say.
std::vector<knowledge::Alternative> Together(const std::vector<knowledge::Alternative>& one,
                                             const std::vector<knowledge::Alternative>& other) {
  std::map<std::string, double> chances;
  for (const auto* const heard : {&one, &other}) {
    for (const auto& [text, chance] : *heard) chances[text] += chance / 2;
  }
  std::vector<knowledge::Alternative> alternatives;
  for (const auto& [text, chance] : chances) {
    if (chance >= kLeastChance) alternatives.push_back({text, chance});
  }
  std::stable_sort(alternatives.begin(), alternatives.end(),
                   [](const auto& a, const auto& b) { return a.chance > b.chance; });
  return alternatives;
}

// Empty if nobody speaks in it.
Sound Clear(const Sound& sound) {
  Sound clear = WithoutNoise(Resampled(sound, kHearingRate));
  const bool is_loud = std::any_of(clear.samples.begin(), clear.samples.end(),
                                   [](int sample) { return std::abs(sample) > kLoudEnough; });
  if (!is_loud) clear.samples.clear();
  return clear;
}

}  // namespace

Expected<std::unique_ptr<Recognizer>> Recognizer::Make(const std::string& model_folder,
                                                       const SpokenLanguage& spoken) {
  const auto dictionary = Pronunciations::Load(model_folder + "/cmudict-en-us.dict");
  if (!dictionary) return Problem{dictionary.problem()};
  std::unique_ptr<Recognizer> made(new Recognizer);
  NgramCounts common;
  common.lower = kStrict.surprise;
  common.anywhere = kStrict.anything;
  const Outcome added =
      AddCommonWords(model_folder, spoken, kStrict.common_words, *dictionary, common);
  if (!added) return Problem{added.problem()};
  made->SetReplies(common, spoken);
  const NgramCounts sentences = CountsOf(spoken);
  for (const Expectation& expectation : {kStrict, kOpen}) {
    NgramCounts counts = sentences;
    counts.lower = expectation.surprise;
    counts.anywhere = expectation.anything;
    const Outcome more =
        AddCommonWords(model_folder, spoken, expectation.common_words, *dictionary, counts);
    if (!more) return Problem{more.problem()};
    auto decoder = Decoder::Make(model_folder, *dictionary, counts, expectation);
    if (!decoder) return Problem{decoder.problem()};
    made->decoders_.push_back(*std::move(decoder));
  }
  return made;
}

void Recognizer::SetReplies(const NgramCounts& common, const SpokenLanguage& spoken) {
  replies_ = common;
  ForEachReply(spoken, [this](const Sentence& reply, double weight) {
    replies_.Add(reply, weight);
    words_of_replies_.insert(reply.begin(), reply.end());
  });
}

std::vector<knowledge::Alternative> Recognizer::Recognize(const Sound& sound) {
  const Sound clear = Clear(sound);
  std::vector<knowledge::Alternative> other;
  std::thread thread([&] { other = decoders_[1].Recognize(clear); });
  const std::vector<knowledge::Alternative> one = decoders_[0].Recognize(clear);
  thread.join();
  return Together(one, other);
}

// The model of what may be replied is small and made anew for other names.
void Recognizer::ExpectReply(const std::vector<std::string>& names) {
  if (expects_reply_ && names == names_) return;
  expects_reply_ = true;
  names_ = names;
  NgramCounts counts = replies_;
  words_ = words_of_replies_;
  ForEachNamed(names, [&](const Sentence& reply, double weight) {
    counts.Add(reply, weight);
    words_.insert(reply.begin(), reply.end());
  });
  decoders_[0].SetReplies(counts);
}

std::vector<knowledge::Alternative> Recognizer::RecognizeReply(
    const Sound& sound, const std::vector<std::string>& names) {
  ExpectReply(names);
  std::vector<knowledge::Alternative> alternatives = decoders_[0].RecognizeReply(Clear(sound));
  double replies = 0;
  for (const knowledge::Alternative& alternative : alternatives) {
    const auto words = knowledge::SplitWords(alternative.text);
    const bool is_reply = std::all_of(words.begin(), words.end(), [this](const std::string& word) {
      return words_.count(word) > 0;
    });
    replies += is_reply ? alternative.chance : 0;
  }
  if (replies < kLeastReply) alternatives.clear();
  return alternatives;
}

}  // namespace coppice::robot::speech
