// How well the robot hears what people ask, and how fast: utterances that were written by hand,
// spoken by voices of espeak-ng in noise, recognized by pocketsphinx, understood. `./dev bench
// speech` builds and runs it.
//
//   coppice_speech_bench [--every N] [--misses]
//
// --every: only each Nth utterance. --misses: also lists what was not heard right of the utterances
// that limits may be chosen by; no others are spoken then. Exit status 1 if a figure is below its
// bar (docs/service.md).
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "robot_app/knowledge/store/queries.h"
#include "robot_app/speech/ear/listener.h"
#include "robot_app/speech/ear/recognizer.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/knowledge/understanding_figures.h"
#include "tests/robot_app/speech/noisy_speech.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Hearing;
using knowledge::HearingCounts;
using knowledge::Language;
using knowledge::SpokenExample;

// Of 37 voices these are heard best, by 14 sentences that are not in the set: their consonants are
// as loud beside the vowels as people's. The plain "en-us" is heard badly (docs/service.md).
const std::vector<std::string> kVoices = {"en-us+f2", "en-us+klatt", "en-us+f5", "en-us+m6"};
constexpr int kWordsPerMinute = 150;
constexpr double kLeastRight = 0.8, kLeastPlaces = 0.85, kMostWrong = 0.03;
// What the mouth then has to make.
constexpr char kAnswer[] =
    "Anna Weber is in office 101, on the ground floor of the institute building. I can take you "
    "there.";
constexpr double kLongestAnswer = 0.3;  // s after the end of speech, of nine in ten

bool IsPlaceSearch(const SpokenExample& example) {
  return example.slots.find("place=") == 0 &&
         (example.intent == "find_place" || example.intent == "guide");
}

// What became of the utterances in a noise.
struct Figures {
  HearingCounts counts;
  std::map<std::string, HearingCounts> of_voices;
  int places = 0, places_found = 0;  // with at most one question back
  std::vector<double> seconds;       // from the end of speech to the answer

  void Add(const SpokenExample& example, const std::string& voice, Hearing hearing, double took) {
    counts.Add(example, hearing);
    of_voices[voice].Add(example, hearing);
    seconds.push_back(took);
    if (!IsPlaceSearch(example)) return;
    ++places;
    places_found += hearing == Hearing::kRight || hearing == Hearing::kAsked ? 1 : 0;
  }
  double place_share() const { return static_cast<double>(places_found) / places; }
  double SlowestOfTen() {
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() * 9 / 10];
  }
};

bool Print(const char* what, double snr, Figures& figures) {
  const HearingCounts& counts = figures.counts;
  std::printf(
      "%2.0f dB, %-8s right %5.1f %% of %d, places %5.1f %% of %d, unanswerable refused %5.1f %% of "
      "%d, wrong action %4.1f %%, answered within %.0f ms\n",
      snr, what, 100 * counts.right_share(), counts.answerable, 100 * figures.place_share(),
      figures.places, 100 * counts.refused_share(), counts.unanswerable, 100 * counts.wrong_share(),
      1000 * figures.SlowestOfTen());
  for (const auto& [voice, of_voice] : figures.of_voices) {
    std::printf("         %-12s right %5.1f %%\n", voice.c_str(), 100 * of_voice.right_share());
  }
  return counts.right_share() >= kLeastRight && counts.wrong_share() <= kMostWrong &&
         figures.place_share() >= kLeastPlaces && figures.SlowestOfTen() <= kLongestAnswer;
}

class Bench {
 public:
  Bench(int every, bool lists_misses) : every_(every), lists_misses_(lists_misses) {
    auto made = Recognizer::Make(kEnglishModel, {table_, words_, names_});
    if (!made) throw std::runtime_error(made.problem());
    recognizer_ = *std::move(made);
  }

  bool Measure(double snr) {
    Figures tuned, held_out;
    for (std::size_t i = 0; i < examples_.size(); i += static_cast<std::size_t>(every_)) {
      const SpokenExample& example = examples_[i];
      if (lists_misses_ && example.is_held_out) continue;
      const std::string& voice = kVoices[i / static_cast<std::size_t>(every_) % kVoices.size()];
      Speak(example, voice, snr, static_cast<unsigned>(i), example.is_held_out ? held_out : tuned);
    }
    const bool is_good = Print("tuned", snr, tuned);
    return lists_misses_ ? is_good : Print("held out", snr, held_out) && is_good;
  }

 private:
  void Speak(const SpokenExample& example, const std::string& voice, double snr, unsigned seed,
             Figures& figures) {
    const auto said = voices_.Speak(example.text, {voice, kWordsPerMinute});
    if (!said) throw std::runtime_error(said.problem());
    const Sound sound = Resampled(InNoise(said->sound, snr, seed), kHearingRate);
    const auto begin = std::chrono::steady_clock::now();
    const auto heard = LikeliestMeaning(understander_, recognizer_->Recognize(sound));
    const bool is_sure = heard.share >= kSureEnough;
    const knowledge::Understanding understood = understander_.Understand(is_sure ? heard.text : "");
    static_cast<void>(voices_.Speak(kAnswer, {"en-us", kWordsPerMinute}));
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    const Hearing hearing = HearingOf(understood, example);
    figures.Add(example, voice, hearing, took.count());
    if (!lists_misses_ || hearing == Hearing::kRight) return;
    std::printf("    %-12s %-45s | %-45s %.2f %s %s -> %s%s\n", voice.c_str(), example.text.c_str(),
                heard.text.c_str(), heard.share, example.intent.c_str(), example.slots.c_str(),
                TextOf(understood).c_str(), hearing == Hearing::kWrongAction ? " WRONG" : "");
  }

  const int every_;
  const bool lists_misses_;
  const std::string folder_ = SourceFolder() + "/robot_app/knowledge/language";
  Diagnostics diagnostics_;
  knowledge::SampleDatabase sample_;
  const knowledge::IntentTable table_ =
      knowledge::LoadIntentTable(folder_ + "/intents.yaml", diagnostics_);
  const knowledge::LanguageWords words_ =
      knowledge::LoadLanguageWords(folder_, Language::kEnglish, diagnostics_);
  const std::vector<knowledge::Name> names_ = knowledge::Names(*sample_);
  const knowledge::Understander understander_{table_, words_, names_, Language::kEnglish};
  const std::vector<SpokenExample> examples_ =
      knowledge::LoadExamples(SourceFolder() + "/tests/robot_app/knowledge/utterances.en.csv");
  const Synthesizer voices_;
  std::unique_ptr<Recognizer> recognizer_;
};

int Main(const std::vector<std::string>& arguments) {
  int every = 1;
  bool lists_misses = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--misses") lists_misses = true;
    if (arguments[i] == "--every" && i + 1 < arguments.size()) every = std::stoi(arguments[i + 1]);
  }
  Bench bench(every, lists_misses);
  bool is_good = bench.Measure(20);
  is_good &= bench.Measure(10);
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::speech

int main(int argc, char** argv) { return coppice::robot::speech::Main({argv + 1, argv + argc}); }
