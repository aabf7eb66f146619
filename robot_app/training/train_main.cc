// coppice-train: makes the files that the robot's classifiers know from, and says how good they
// are.
#include <cstdio>
#include <string>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/training/people_training.h"
#include "robot_app/training/tracking_figures.h"

namespace coppice::robot::training {
namespace {

const Command kPeople{
    "coppice-train",
    "learn to see people in clouds of the 3-D lidar",
    {"people FILE", 2, 2},
    "Writes FILE, a classifier learnt from simulated scans of random halls, or\n"
    "with --measure says how well FILE finds people on the institute's floor.\n"
    "The same options write the same file.",
    {CommandOption::Whole("--seed", "N", 1, 1000000000, "of the halls; else 1"),
     CommandOption::Whole("--scans", "N", 1, 100000, "of a round; else 700"),
     CommandOption::Whole("--rounds", "N", 1, 10, "else 3"),
     CommandOption::Flag("--measure", "reads FILE instead of writing it"),
     CommandOption::Flag("--without-picture", "measure clustering by distance alone")}};

int Fail(const std::string& problem) {
  std::fprintf(stderr, "coppice-train: %s\n", problem.c_str());
  return 1;
}

int Measure(const Options& options) {
  Diagnostics diagnostics;
  const auto floor = simulation::LoadFloor(COPPICE_FLOOR, diagnostics);
  if (!floor) return Fail(diagnostics.ToString());
  auto classifier = perception::PersonClassifier::Load(options.files[1]);
  if (!classifier) return Fail(classifier.problem());
  perception::FinderOptions finding;
  finding.candidates.with_depth_steps = !options.Has("--without-picture");
  perception::PeopleFinder finder(finding, std::move(*classifier));
  const auto scans = static_cast<int>(options.Whole("--scans", 700));
  const auto seed = static_cast<std::uint64_t>(options.Whole("--seed", 1)) + 1000000;
  std::fputs(Table(MeasurePeople(finder, SiteOf(*floor), scans, seed)).c_str(), stdout);
  TrackingScenario scenario;
  scenario.seed = seed;
  std::fputs(("\nTen people for a minute: " + Summary(MeasureTracking(finder, scenario))).c_str(),
             stdout);
  return 0;
}

int Train(const Options& options) {
  PeopleTrainingOptions training;
  training.seed = static_cast<std::uint64_t>(options.Whole("--seed", 1));
  training.scans = static_cast<int>(options.Whole("--scans", training.scans));
  training.rounds = static_cast<int>(options.Whole("--rounds", training.rounds));
  const auto classifier =
      TrainPeople(training, [](double share) { std::fprintf(stderr, "\r%3.0f %%", 100 * share); });
  std::fputs("\n", stderr);
  if (!classifier) return Fail(classifier.problem());
  const Outcome saved = classifier->Save(options.files[1]);
  return saved ? 0 : Fail(saved.problem());
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(kPeople, arguments);
  if (options.exit) return *options.exit;
  if (options.files[0] != "people") {
    return RefuseOptions(kPeople, "it can learn people, not \"" + options.files[0] + "\"");
  }
  return options.Has("--measure") ? Measure(options) : Train(options);
}

}  // namespace
}  // namespace coppice::robot::training

int main(int argc, char** argv) { return coppice::robot::training::Main({argv + 1, argv + argc}); }
