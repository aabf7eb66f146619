// How well the robot hears what people ask, and how fast: utterances that were written by hand,
// spoken by voices of espeak-ng in noise, recognized by pocketsphinx, understood. Where the robot
// asks back, the same voice replies in the same noise what the visitor would. The sound comes as
// from a microphone, 20 ms at a time, with noise before and behind. `./dev bench speech` builds and
// runs it. Exit status 1 if a figure is below its bar (docs/service.md).
#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "robot_app/knowledge/answers/dialogue.h"
#include "robot_app/knowledge/store/queries.h"
#include "robot_app/speech/ear/ear.h"
#include "robot_app/speech/ear/recognizer.h"
#include "tests/robot_app/knowledge/language_files.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/knowledge/understanding_figures.h"
#include "tests/robot_app/speech/noisy_speech.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Alternative;
using knowledge::Answer;
using knowledge::AnswerMood;
using knowledge::Choice;
using knowledge::Hearing;
using knowledge::Language;
using knowledge::SpokenExample;
using knowledge::Understanding;
using knowledge::Verdict;

const Command kBench{
    "coppice_speech_bench",
    "how well the robot hears what people ask, and how fast",
    {"", 0, 0},
    "All of it takes some seven minutes.",
    {CommandOption::Whole("--every", "N", 1, 1000, "only each Nth utterance"),
     CommandOption::Flag("--misses",
                         "also list what was not heard right, and speak none that are held out")}};

// Of 37 voices these are heard best, by 14 sentences that are not in the set: their consonants are
// as loud beside the vowels as people's. The plain "en-us" is heard badly (docs/service.md).
const std::vector<std::string> kVoices = {"en-us+f2", "en-us+klatt", "en-us+f5", "en-us+m6"};
constexpr int kWordsPerMinute = 150;
constexpr double kLeastRight = 0.8, kLeastPlaces = 0.85, kMostWrong = 0.03;
// What the mouth then has to make.
constexpr char kAnswer[] =
    "Anna Weber is in office 101, on the ground floor of the institute building. I can take you "
    "there.";
constexpr double kLongestAnswer = 0.3;  // s after the end of speech was noticed, of nine in ten
constexpr double kAround = 1.0;         // s of noise before and behind
constexpr int kWarmUp = 5;              // so often it hears what is before, to know the noise
constexpr std::size_t kPiece = kHearingRate / 50;
constexpr ActivitySettings kActivity;

using Instant = std::chrono::steady_clock::time_point;
double SecondsSince(Instant begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// What was heard, and when the recognizer was done: after the ear took it for the end [s].
struct Recognized {
  std::vector<Alternative> alternatives;
  double late = 0;
};

bool IsPlaceSearch(const SpokenExample& example) {
  return example.slots.find("place=") == 0 &&
         (example.intent == "find_place" || example.intent == "guide");
}

Hearing HearingOf(const knowledge::Request& request, const SpokenExample& example) {
  return knowledge::HearingOf({Verdict::kUnderstood, request, {}, {}}, example);
}

// Where one of several has to be asked back, all of them are.
Hearing HearingOf(const Answer& answer, const SpokenExample& example) {
  if (answer.request) return HearingOf(*answer.request, example);
  if (answer.mood != AnswerMood::kAsking) return knowledge::HearingOf({}, example);
  Understanding asked{Verdict::kAmbiguous, {}, {}, {}};
  for (const Choice& choice : answer.choices) {
    if (HearingOf(choice.request, example) == Hearing::kRight) return Hearing::kAsked;
    asked.request.intent = choice.request.intent;
    if (!choice.request.slots.empty()) asked.choices.push_back(choice.request.slots.front());
  }
  return knowledge::HearingOf(asked, example);
}

// What became of the utterances in a noise.
struct Figures {
  int answerable = 0, unanswerable = 0;
  int right = 0, right_asked = 0;      // without and with a question back, of the answerable ones
  int refused = 0, refused_asked = 0;  // likewise, of the unanswerable ones
  int asked = 0, wrong = 0;
  int places = 0, places_found = 0;  // with at most one question back
  std::vector<double> seconds;       // from when its end was noticed to the answer's first sound

  void Add(const SpokenExample& example, Hearing first, Hearing last, double took) {
    const bool can_be_answered = example.intent != "none";
    const bool is_right = first == Hearing::kRight, is_right_at_last = last == Hearing::kRight;
    (can_be_answered ? answerable : unanswerable) += 1;
    (can_be_answered ? right : refused) += is_right ? 1 : 0;
    (can_be_answered ? right_asked : refused_asked) += is_right_at_last ? 1 : 0;
    asked += first == Hearing::kAsked || first == Hearing::kWrongChoice ? 1 : 0;
    wrong += last == Hearing::kWrongAction ? 1 : 0;
    seconds.push_back(took);
    if (!IsPlaceSearch(example)) return;
    ++places;
    places_found += is_right_at_last ? 1 : 0;
  }
  double SlowestOfTen() {
    std::sort(seconds.begin(), seconds.end());
    return seconds[seconds.size() * 9 / 10];
  }
};

double Percent(int part, int whole) { return whole == 0 ? 0 : 100.0 * part / whole; }

bool Print(const char* what, double snr, Figures& f) {
  const int all = f.answerable + f.unanswerable;
  std::printf(
      "%2.0f dB, %-8s right %5.1f %% of %d, with one question back %5.1f %%; asked back %5.1f %%; "
      "places %d of %d; unanswerable refused %d, in the end %d of %d; wrong action %4.1f %%; "
      "answer begins within %.0f ms, %.0f ms after the last sound\n",
      snr, what, Percent(f.right, f.answerable), f.answerable, Percent(f.right_asked, f.answerable),
      Percent(f.asked, all), f.places_found, f.places, f.refused, f.refused_asked, f.unanswerable,
      Percent(f.wrong, all), 1000 * f.SlowestOfTen(),
      1000 * (f.SlowestOfTen() + kActivity.ends_after));
  return f.right_asked >= kLeastRight * f.answerable && f.wrong <= kMostWrong * all &&
         f.places_found >= kLeastPlaces * f.places && f.SlowestOfTen() <= kLongestAnswer;
}

class Bench {
 public:
  Bench(int every, bool lists_misses) : every_(every), lists_misses_(lists_misses) {
    const auto& files = knowledge::ShippedLanguageFiles();
    const auto& words = In(Language::kEnglish, files.words);
    auto made = Recognizer::Make(kEnglishModel, {files.intents, words, knowledge::Names(*sample_)});
    if (!made) throw std::runtime_error(made.problem());
    recognizer_ = *std::move(made);
    dialogue_ =
        knowledge::Dialogue::Open(sample_.path(), knowledge::LanguageFolder(), diagnostics_);
    if (!dialogue_) throw std::runtime_error(diagnostics_.ToString());
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
  Sound Said(const std::string& text, const std::string& voice, double snr, unsigned seed) const {
    const auto said = voices_.Speak(text, {voice, kWordsPerMinute});
    if (!said) throw std::runtime_error(said.problem());
    return Resampled(InNoise(said->sound, snr, seed, kAround), kHearingRate);
  }

  // As the listener does: while somebody pauses, what he has said is recognized already.
  template <class Recognize>
  static Recognized Hear(const Sound& sound, const Recognize& recognize) {
    Ear ear({kActivity, 0.4}, Listening::kAlways);
    Recognized heard;
    std::optional<Utterance> foreseen;
    const auto before = sound.samples.begin();
    const auto half = static_cast<std::ptrdiff_t>(kAround * kHearingRate / 2);
    for (int i = 0; i < kWarmUp; ++i) ear.Hear({before, before + half}, {});
    for (std::size_t at = 0; at + kPiece <= sound.samples.size(); at += kPiece) {
      const auto piece = sound.samples.begin() + static_cast<std::ptrdiff_t>(at);
      auto utterance = ear.Hear({piece, piece + kPiece}, {});
      if (!utterance) continue;
      const bool is_known = foreseen && foreseen->sound.samples == utterance->sound.samples;
      if (!is_known) {
        const Instant begin = std::chrono::steady_clock::now();
        heard.alternatives = recognize(utterance->sound);
        heard.late = SecondsSince(begin);
      }
      if (utterance->has_ended) {
        const double waited = is_known ? kActivity.ends_after - kActivity.pauses_after : 0;
        heard.late = std::max(heard.late - waited, 0.0);
        return heard;
      }
      foreseen = std::move(utterance);
    }
    return {};
  }

  void Speak(const SpokenExample& example, const std::string& voice, double snr, unsigned seed,
             Figures& figures) {
    const Sound sound = Said(example.text, voice, snr, seed);
    dialogue_->Forget();
    dialogue_->set_language(Language::kEnglish);
    const Recognized recognized =
        Hear(sound, [this](const Sound& said) { return recognizer_->Recognize(said); });
    const Instant begin = std::chrono::steady_clock::now();
    const knowledge::HeardAnswer heard = dialogue_->Hear(recognized.alternatives, now_);
    static_cast<void>(voices_.Speak(kAnswer, {"en-us", kWordsPerMinute}));
    const double took = recognized.late + SecondsSince(begin);
    const Hearing first = HearingOf(heard.answer, example);
    const bool is_asked = !heard.answer.choices.empty() && first != Hearing::kRight;
    const std::string reply = is_asked ? ReplyOf(heard.answer, example, seed) : "";
    const Hearing last =
        is_asked ? Reply(example, Said(reply, voice, snr, seed + 1), first) : first;
    figures.Add(example, first, last, took);
    if (!lists_misses_ || first == Hearing::kRight) return;
    std::printf("    %-12s %-45s | %-45s %.2f %s %s -> %s%s%s\n", voice.c_str(),
                example.text.c_str(), heard.text.c_str(), heard.share, example.intent.c_str(),
                example.slots.c_str(), heard.answer.text.substr(0, 60).c_str(),
                is_asked ? (" \"" + reply + "\"").c_str() : "",
                last == Hearing::kWrongAction ? " WRONG"
                : last == Hearing::kRight     ? " right"
                                              : "");
  }

  // By its number or by its name in turn.
  static std::string ReplyOf(const Answer& asked, const SpokenExample& example, unsigned seed) {
    static const std::vector<std::string> kNumbers = {"the first one", "the second one",
                                                      "the third one"};
    for (std::size_t i = 0; i < asked.choices.size(); ++i) {
      if (HearingOf(asked.choices[i].request, example) != Hearing::kRight) continue;
      const std::string& label = asked.choices[i].label;
      return label == "Yes" || seed % 2 == 0 ? (label == "Yes" ? "yes" : kNumbers[i]) : label;
    }
    return "no";
  }

  Hearing Reply(const SpokenExample& example, const Sound& sound, Hearing first) {
    const std::vector<std::string> names = dialogue_->ExpectedNames(now_);
    const Recognized recognized = Hear(sound, [&](const Sound& said) {
      auto heard = recognizer_->RecognizeReply(said, names);
      return heard.empty() ? recognizer_->Recognize(said) : heard;
    });
    const Answer answer = dialogue_->Hear(recognized.alternatives, now_).answer;
    const bool is_none = answer.request && answer.request->intent == knowledge::Intent::kCancel;
    if (is_none || !answer.request) {
      return example.intent == "none"   ? Hearing::kRight
             : first == Hearing::kAsked ? Hearing::kRefused
                                        : first;
    }
    return HearingOf(*answer.request, example);
  }

  const int every_;
  const bool lists_misses_;
  Diagnostics diagnostics_;
  knowledge::SampleDatabase sample_;
  const WallTime now_ = sample_.At("2026-11-25", 12);
  std::unique_ptr<knowledge::Dialogue> dialogue_;
  const std::vector<SpokenExample> examples_ =
      knowledge::LoadExamples(SourceFolder() + "/tests/robot_app/knowledge/utterances.en.csv");
  const Synthesizer voices_;
  std::unique_ptr<Recognizer> recognizer_;
};

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kBench, arguments);
  if (options.exit) return *options.exit;
  Bench bench(static_cast<int>(options.Whole("--every", 1)), options.Has("--misses"));
  bool is_good = bench.Measure(20);
  is_good &= bench.Measure(10);
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::speech

int main(int argc, char** argv) { return coppice::robot::speech::Main({argv + 1, argv + argc}); }
