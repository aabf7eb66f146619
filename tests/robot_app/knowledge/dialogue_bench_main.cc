// How well the robot understands what people ask, and how fast. `./dev bench dialogue` builds and
// runs it. Exit status 1 if a figure is below its bar (docs/service.md).
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "tests/robot_app/knowledge/sample_database.h"
#include "tests/robot_app/knowledge/understanding_figures.h"

namespace coppice::robot::knowledge {
namespace {

const Command kBench{
    "coppice_dialogue_bench",
    "how well the robot understands what people ask, and how fast",
    {"", 0, 0},
    "",
    {CommandOption::Text("--utterances", "FILE",
                         "others, in English: lines of \"text,intent,slots,held_out\""),
     CommandOption::Flag("--misses",
                         "also list what was not understood of what phrases may be chosen by")}};

constexpr double kLeastRight = 0.95, kLeastRefused = 0.9, kMostWrong = 0.03;

bool Print(const char* what, const HearingCounts& counts) {
  std::printf(
      "  %-10s right %5.1f %% of %d, asked back %d, unanswerable refused %5.1f %% of %d, "
      "wrong action %4.1f %%\n",
      what, 100 * counts.right_share(), counts.answerable, counts.asked,
      100 * counts.refused_share(), counts.unanswerable, 100 * counts.wrong_share());
  return counts.right_share() >= kLeastRight && counts.refused_share() >= kLeastRefused &&
         counts.wrong_share() <= kMostWrong;
}

bool Measure(SampleDatabase& sample, Language language, const std::string& utterances,
             bool lists_misses) {
  Diagnostics diagnostics;
  const std::string folder = SourceFolder() + "/robot_app/knowledge/language";
  const IntentTable table = LoadIntentTable(folder + "/intents.yaml", diagnostics);
  const LanguageWords words = LoadLanguageWords(folder, language, diagnostics);
  std::fputs(diagnostics.ToString().c_str(), stderr);
  const Understander understander(table, words, Names(*sample), language);
  const auto examples = LoadExamples(utterances);
  HearingCounts tuned, held_out;
  std::chrono::duration<double, std::milli> longest{0}, sum{0};
  for (const SpokenExample& example : examples) {
    const auto begin = std::chrono::steady_clock::now();
    const Understanding heard = understander.Understand(example.text);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    longest = std::max(longest, took);
    sum += took;
    const Hearing hearing = HearingOf(heard, example);
    (example.is_held_out ? held_out : tuned).Add(example, hearing);
    if (lists_misses && !example.is_held_out && hearing != Hearing::kRight) {
      std::printf("    %-50s %s %s -> %s\n", example.text.c_str(), example.intent.c_str(),
                  example.slots.c_str(), TextOf(heard).c_str());
    }
  }
  std::printf("%s, typed, %zu utterances, %.2f ms each, at most %.1f ms\n", Code(language),
              examples.size(), sum.count() / static_cast<double>(examples.size()), longest.count());
  const bool is_good = Print("tuned", tuned);
  return Print("held out", held_out) && is_good;
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kBench, arguments);
  if (options.exit) return *options.exit;
  SampleDatabase sample;
  bool is_good = true;
  const bool misses = options.Has("--misses");
  if (options.Has("--utterances")) {
    return Measure(sample, Language::kEnglish, options.Get("--utterances"), misses) ? 0 : 1;
  }
  for (const Language language : kLanguages) {
    is_good &= Measure(sample, language, UtterancesFile(language), misses);
  }
  return is_good ? 0 : 1;
}

}  // namespace
}  // namespace coppice::robot::knowledge

int main(int argc, char** argv) { return coppice::robot::knowledge::Main({argv + 1, argv + argc}); }
