#include "bt_core/cli/test/test_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bt_core/engine/compile/models.h"

namespace coppice {
namespace {

bool Passed(const TestedScenario& scenario) { return scenario.result.differences.empty(); }

std::string Place(const SourceLocation& where) {
  return where.file + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

std::string StepOf(const Difference& difference) {
  return difference.step ? "step " + std::to_string(difference.step) + ": " : "";
}

std::string Describe(const Difference& difference) {
  return Place(difference.where) + ": " + StepOf(difference) + difference.what + "\n    expected " +
         difference.expected + "\n    got      " + difference.got + "\n";
}

long CountPassed(const TestedFile& file) {
  return std::count_if(file.scenarios.begin(), file.scenarios.end(),
                       [](const TestedScenario& scenario) { return Passed(scenario); });
}

}  // namespace

bool Passed(const TestedFile& file) {
  return file.errors.empty() && CountPassed(file) == static_cast<long>(file.scenarios.size());
}

std::string ReportText(const std::vector<TestedFile>& files) {
  std::ostringstream out;
  long passed = 0;
  long failed = 0;
  for (const TestedFile& file : files) {
    out << file.errors;
    for (const TestedScenario& scenario : file.scenarios) {
      const bool good = Passed(scenario);
      ++(good ? passed : failed);
      out << (good ? "ok    " : "FAIL  ") << file.file << ": " << scenario.name << "\n";
      for (const Difference& difference : scenario.result.differences) {
        out << "  " << Describe(difference);
      }
    }
  }
  out << passed << " passed, " << failed << " failed\n";
  return out.str();
}

std::string ReportJson(const std::vector<TestedFile>& files) {
  using Json = nlohmann::ordered_json;
  Json json = {{"passed", true}, {"files", Json::array()}};
  for (const TestedFile& file : files) {
    if (!Passed(file)) json["passed"] = false;
    Json scenarios = Json::array();
    for (const TestedScenario& scenario : file.scenarios) {
      Json differences = Json::array();
      for (const Difference& difference : scenario.result.differences) {
        differences.push_back({{"line", difference.where.line},
                               {"column", difference.where.column},
                               {"step", difference.step},
                               {"what", difference.what},
                               {"expected", difference.expected},
                               {"got", difference.got}});
      }
      scenarios.push_back({{"name", scenario.name},
                           {"passed", Passed(scenario)},
                           {"ticks", scenario.result.ticks},
                           {"seconds", scenario.seconds},
                           {"differences", std::move(differences)}});
    }
    Json entry = {{"file", file.file}, {"scenarios", std::move(scenarios)}};
    if (!file.errors.empty()) entry["errors"] = file.errors;
    json["files"].push_back(std::move(entry));
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ReportJUnit(const std::vector<TestedFile>& files) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const TestedFile& file : files) {
    const auto failures = static_cast<long>(file.scenarios.size()) - CountPassed(file);
    out << "  <testsuite name=\"" << EscapeXml(file.file) << "\" tests=\""
        << file.scenarios.size() + (file.errors.empty() ? 0 : 1) << "\" failures=\"" << failures
        << "\" errors=\"" << (file.errors.empty() ? 0 : 1) << "\">\n";
    if (!file.errors.empty()) {
      out << "    <testcase name=\"load\"><error message=\"" << EscapeXml(file.errors)
          << "\"/></testcase>\n";
    }
    for (const TestedScenario& scenario : file.scenarios) {
      out << "    <testcase name=\"" << EscapeXml(scenario.name) << "\" time=\"" << scenario.seconds
          << "\">";
      for (const Difference& difference : scenario.result.differences) {
        out << "\n      <failure message=\"" << EscapeXml(Describe(difference)) << "\"/>";
      }
      out << (Passed(scenario) ? "" : "\n    ") << "</testcase>\n";
    }
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace coppice
