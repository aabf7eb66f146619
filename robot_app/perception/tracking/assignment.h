// Who belongs to whom, so that the sum of the costs is least.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_TRACKING_ASSIGNMENT_H_
#define COPPICE_ROBOT_APP_PERCEPTION_TRACKING_ASSIGNMENT_H_

#include <Eigen/Core>
#include <vector>

namespace coppice::robot::perception {

/// For each row of `costs` the column that it gets, or -1; a column goes to one row at most. Pairs
/// that cost `too_much` or more are never made; of all ways to make as many of the others as
/// possible it is the cheapest. The Hungarian method with shortest augmenting paths (Jonker and
/// Volgenant 1987), O(n^3).
std::vector<int> Assign(const Eigen::MatrixXd& costs, double too_much);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_TRACKING_ASSIGNMENT_H_
