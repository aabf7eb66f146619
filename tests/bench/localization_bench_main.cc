// Does a robot that was put anywhere find out where it is? `./dev bench localization`.
#include <cstdio>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "tests/bench/carried_picture.h"
#include "tests/robot_app/slam/carried_study.h"

namespace coppice::robot::slam {
namespace {

constexpr unsigned kSeed = 12;

const Command kBench{
    "coppice_localization_bench",
    "does a robot that was put anywhere find out where it is",
    {"", 0, 0},
    "It is carried there, or started there, and turned once; by its laser alone and with the places\n"
    "that it recognizes in pictures. Some ten minutes on one core.",
    {CommandOption::Whole("--places", "N", 1, 10000, "else 200"),
     CommandOption::Flag("--details", "a line for each place that was not found"),
     CommandOption::Real("--dusk", "LIGHT", 0.01, 1, "also in so much light; else 0.1"),
     CommandOption::Text("--picture", "FILE", "paint where it was found when carried (SVG)")}};

void Say(double share) { std::fprintf(stderr, "\r%3.0f %% ", 100 * share); }

void PrintWhatWasNotFound(const std::vector<CarriedOutcome>& outcomes) {
  for (const CarriedOutcome& one : outcomes) {
    if (one.found() && one.wrong == 0) continue;
    std::fprintf(stderr, "(%.2f, %.2f, %.2f): phase %d, %.2f m off, wrong for %.1f s, %d hints\n",
                 one.place.x, one.place.y, one.place.yaw, static_cast<int>(one.phase), one.error,
                 one.wrong, one.hints);
  }
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kBench, arguments);
  if (options.exit) return *options.exit;
  const int places = static_cast<int>(options.Whole("--places", 200));
  KnownInstitute institute(RoundOfAllRooms());
  struct Row {
    const char* name;
    CarriedOptions options;
    double light;
  };
  const double dusk = options.Real("--dusk", 0.1);
  std::vector<DrawnStudy> drawn;
  std::printf("%s", TableHead().c_str());
  for (const Row& row : {Row{"carried, laser alone", {false, true}, 1},
                         Row{"carried, with pictures", {true, true}, 1},
                         Row{"carried, with pictures at dusk", {true, true}, dusk},
                         Row{"started, laser alone", {false, false}, 1},
                         Row{"started, with pictures", {true, false}, 1}}) {
    institute.SetLight(row.light);
    const auto outcomes = PutAnywhere(institute, places, kSeed, row.options, Say);
    std::printf("%s", TableLine(row.name, outcomes).c_str());
    std::fflush(stdout);
    if (options.Has("--details")) PrintWhatWasNotFound(outcomes);
    if (row.options.carried && row.light == 1) drawn.push_back({row.name, outcomes});
  }
  if (!options.Has("--picture")) return 0;
  if (DrawCarried(institute.floor(), drawn, options.Get("--picture"))) return 0;
  std::fprintf(stderr, "%s cannot be written\n", options.Get("--picture").c_str());
  return 1;
}

}  // namespace
}  // namespace coppice::robot::slam

int main(int argc, char** argv) { return coppice::robot::slam::Main({argv + 1, argv + argc}); }
