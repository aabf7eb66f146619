// coppice-deployment: the robot's sixteen days in minutes, and their report.
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/shipped.h"
#include "robot_app/deployment/report/report.h"
#include "robot_app/deployment/run_seeds.h"

namespace coppice::robot::deployment {
namespace {

const Command kRun{
    "coppice-deployment run",
    "let robots run for sixteen days in minutes",
    {},
    "Each seed is a file, FOLDER/CONTROLLER/seed-0001.json; one that is there is done, so what was\n"
    "broken off goes on, and many computers may share the seeds.",
    {CommandOption::Text("--out", "FOLDER", "where the runs are kept").Needed(),
     CommandOption::Text("--seeds", "SEEDS", "1-20, or 1,5,7-9; else 1"),
     CommandOption::Whole("--jobs", "N", 1, 256, "seeds at a time; else 1"),
     CommandOption::Text("--controller", "NAME",
                         "who drives: see controllers.yaml; may be given again; else ours"),
     CommandOption::Whole("--days", "N", 1, 366, "ends after so many days"),
     CommandOption::Text("--without", "FAULT", "leaves a fault out; may be given again"),
     CommandOption::Real("--times", "X", 0, 1000, "all faults so many times as often; else 1"),
     CommandOption::Flag("--record", "records both trees beside the runs"),
     CommandOption::Text("--scenario", "FILE", "the world; else the shipped one"),
     CommandOption::Text("--controllers", "FILE", "who drives; else the shipped ones")}};

const Command kReport{
    "coppice-deployment report",
    "the report of deployments",
    {"FOLDER...", 1, kAnyNumber},
    "Joins all runs in the folders and below: report.md with the tables, and report.html, which\n"
    "also shows each seed day by day and needs no network.",
    {CommandOption::Text("--out", "FOLDER", "where the report goes; else the first folder"),
     CommandOption::Text("--scenario", "FILE", "the world; else the shipped one")}};

const std::string kFolder = robot::Shipped(COPPICE_ROOT "/robot_app/deployment/");

int Fail(const std::string& problem) {
  std::cerr << "coppice-deployment: " << problem << "\n";
  return 2;
}

const Controller& Find(const std::vector<Controller>& controllers, const std::string& name) {
  std::vector<std::string> names;
  for (const Controller& controller : controllers) {
    if (controller.name == name) return controller;
    names.push_back(controller.name);
  }
  throw std::runtime_error("there is no controller \"" + name + "\" " + DidYouMean(name, names));
}

void OrThrow(const Outcome& outcome) {
  if (!outcome) throw std::runtime_error(outcome.problem());
}

Scenario ReadScenario(const Options& options, Diagnostics& diagnostics) {
  Scenario scenario =
      LoadScenario(options.Get("--scenario", kFolder + "scenario/scenario.yaml"), diagnostics);
  if (diagnostics.has_errors()) throw std::runtime_error(diagnostics.ToString());
  for (const std::string& fault : options.GetAll("--without")) OrThrow(Without(fault, scenario));
  MultiplyFaults(options.Real("--times", 1), scenario);
  const auto days = static_cast<int>(options.Whole("--days", 0));
  if (days > 0) OrThrow(Shorten(days, scenario));
  return scenario;
}

int Run(const Options& options) {
  const auto seeds = ParseSeeds(options.Get("--seeds", "1"));
  if (!seeds) return Fail(seeds.problem());
  Diagnostics diagnostics;
  const Scenario scenario = ReadScenario(options, diagnostics);
  const std::vector<Controller> controllers =
      LoadControllers(options.Get("--controllers", kFolder + "controllers.yaml"), diagnostics);
  const auto shipped = LoadShipped(robot::Shipped(COPPICE_ROOT), diagnostics);
  if (!shipped || diagnostics.has_errors()) return Fail(diagnostics.ToString());

  std::vector<std::string> names = options.GetAll("--controller");
  if (names.empty()) names = {"ours"};
  for (const std::string& name : names) {
    SeedOptions run;
    run.folder = options.Get("--out") + "/" + name;
    run.is_recorded = options.Has("--record");
    run.without = options.GetAll("--without");
    run.times = options.Real("--times", 1);
    run.jobs = static_cast<int>(options.Whole("--jobs", 1));
    run.tells_progress = true;
    OrThrow(RunSeeds(scenario, *shipped, Find(controllers, name), *seeds, run));
  }
  return 0;
}

void Write(const std::string& path, const std::string& text) {
  Diagnostics diagnostics;
  if (!WriteFile(path, text, diagnostics)) throw std::runtime_error(diagnostics.ToString());
  std::cout << path << "\n";
}

int Report(const Options& options) {
  auto journals = LoadJournals(options.files);
  if (!journals) return Fail(journals.problem());
  Diagnostics diagnostics;
  const Scenario scenario =
      LoadScenario(options.Get("--scenario", kFolder + "scenario/scenario.yaml"), diagnostics);
  if (diagnostics.has_errors()) return Fail(diagnostics.ToString());
  const std::vector<Group> groups = GroupsOf(*std::move(journals));
  const std::string folder = options.Get("--out", options.files[0]);
  std::filesystem::create_directories(folder);
  Write(folder + "/report.md", MarkdownReport(groups));
  Write(folder + "/report.html", HtmlReport(groups, scenario));
  return 0;
}

int Main(const std::vector<std::string>& arguments) {
  const std::string verb = arguments.empty() ? "" : arguments[0];
  if (verb != "run" && verb != "report") {
    const bool asked = verb == "--help" || verb == "-h";
    (asked ? std::cout : std::cerr)
        << "usage: coppice-deployment run|report ... (each has --help)\n";
    return asked ? 0 : 2;
  }
  const Options options =
      ParseOptions(verb == "run" ? kRun : kReport, {arguments.begin() + 1, arguments.end()});
  if (options.exit) return *options.exit;
  try {
    return verb == "run" ? Run(options) : Report(options);
  } catch (const std::exception& error) {
    return Fail(error.what());
  }
}

}  // namespace
}  // namespace coppice::robot::deployment

int main(int argc, char** argv) {
  return coppice::robot::deployment::Main({argv + 1, argv + argc});
}
