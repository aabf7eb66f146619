// The tables of a report: the paper's beside those of simulated deployments, with intervals.
#ifndef COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_SUMMARY_H_
#define COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_SUMMARY_H_

#include <functional>
#include <string>
#include <vector>

#include "robot_app/deployment/figures/figures.h"
#include "robot_app/deployment/figures/intervals.h"
#include "robot_app/deployment/report/table.h"

namespace coppice::robot::deployment {

/// The deployments of one controller in one world.
struct Group {
  std::string name;               ///< of the controller, with what differs from the shipped world
  std::vector<Journal> journals;  ///< by seed
  std::vector<Figures> figures;   ///< of each
};

/// Sorts journals into groups: first ours, then published, then the others by name.
std::vector<Group> GroupsOf(std::vector<Journal> journals);

/// Recoveries of that row, or requests of that subject.
int CountOf(const Journal& journal, const Figures& figures, const std::string& recovery,
            const char* subject);

/// Mean of a figure over the seeds.
double MeanOf(const Group& group, const std::function<double(const Journal&, const Figures&)>& of);

Table MetricsTable(const std::vector<Group>& groups);     ///< as Table II
Table RecoveriesTable(const std::vector<Group>& groups);  ///< as Table III
/// Does the group behave as the published robot? Each figure with the interval within which one
/// deployment lies in 95 of 100 cases, the mean, and how many seeds lie within.
Table ValidationTable(const Group& group);
Table StopsTable(const std::vector<Group>& groups);  ///< by cause
Table ComparisonTable(const std::vector<Group>& groups);

}  // namespace coppice::robot::deployment

#endif  // COPPICE_ROBOT_APP_DEPLOYMENT_REPORT_SUMMARY_H_
