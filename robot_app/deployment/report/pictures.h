// Pictures of deployments as SVG inside of a page: what each seed did when, its battery, where it
// recovered, and how long robots lived without an unplanned stop.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PICTURES_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PICTURES_H_

#include <string>
#include <utility>
#include <vector>

#include "robot_app/deployment/report/summary.h"

namespace coppice::robot::deployment {

/// A colour for each Activity, as a legend.
std::string Legend();
/// The spans of a journal over the days, its unplanned stops and requests, and the battery below.
std::string Timeline(const Journal& journal);
/// Where recoveries of the group began, on the floor's plane [m].
std::string MapOfRecoveries(const Group& group);

/// Share that lives longer than so many hours (E. Kaplan, P. Meier, 1958): what had not ended with
/// its deployment is censored. Steps, from (0, 1) on.
std::vector<std::pair<double, double>> Survival(const Group& group);
std::string SurvivalPicture(const std::vector<Group>& groups);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_PICTURES_H_
