// What `coppice test` tells: for people, as JSON, and as JUnit XML for continuous integration.
#ifndef COPPICE_BT_CORE_CLI_TEST_TEST_REPORT_H_
#define COPPICE_BT_CORE_CLI_TEST_TEST_REPORT_H_

#include <string>
#include <vector>

#include "bt_core/testing/scenario.h"

namespace coppice {

struct TestedScenario {
  std::string name;
  ScenarioResult result;
  double seconds = 0;  ///< of real time
};

struct TestedFile {
  std::string file;
  std::string errors;  ///< why it could not be played; empty if it could
  std::vector<TestedScenario> scenarios;
};

bool Passed(const TestedFile& file);

/// One line per scenario; below it what differed, with the place of each expectation.
std::string ReportText(const std::vector<TestedFile>& files);

/// One JSON object, in one line.
std::string ReportJson(const std::vector<TestedFile>& files);

/// The format that Jenkins, GitLab and others read: one testsuite per file.
std::string ReportJUnit(const std::vector<TestedFile>& files);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_TEST_TEST_REPORT_H_
