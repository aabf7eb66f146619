// What random runs found (bt_core/testing/random_runs.h), for people and for programs.
#ifndef COPPICE_BT_CORE_CLI_TEST_RANDOM_REPORT_H_
#define COPPICE_BT_CORE_CLI_TEST_RANDOM_REPORT_H_

#include <string>

#include "bt_core/testing/random_runs.h"

namespace coppice {

std::string CoverageText(const Coverage& coverage);
/// One JSON object on one line.
std::string CoverageJson(const Coverage& coverage);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_TEST_RANDOM_REPORT_H_
