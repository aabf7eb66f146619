// The report of deployments: one page without network, and the same tables as Markdown.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_REPORT_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_REPORT_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/deployment/report/summary.h"
#include "robot_app/deployment/scenario/scenario.h"

namespace coppice::robot::deployment {

/// All runs (seed-*.json) in these folders and below. A problem if one cannot be read or there is
/// none.
Expected<std::vector<Journal>> LoadJournals(const std::vector<std::string>& folders);

std::string MarkdownReport(const std::vector<Group>& groups);
/// `scenario`: its numbers are listed with their sources.
std::string HtmlReport(const std::vector<Group>& groups, const Scenario& scenario);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_REPORT_H_
