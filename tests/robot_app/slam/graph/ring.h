// A way round a square that climbs a ramp and comes down again, as driven and as measured.
#ifndef COPPICE_TESTS_ROBOT_APP_SLAM_GRAPH_RING_H_
#define COPPICE_TESTS_ROBOT_APP_SLAM_GRAPH_RING_H_

#include <algorithm>
#include <cmath>
#include <vector>

#include "robot_app/slam/graph/pose_graph.h"

namespace coppice::robot::slam {

inline Pose3 Step(double forward, double turn, double pitch = 0) {
  Pose3 step = Pose3::Identity();
  step.translation().x() = forward;
  step.linear() = (Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()))
                      .toRotationMatrix();
  return step;
}

// 40 steps of 1 m; up on the first side, down on the third.
inline std::vector<Pose3> Ring() {
  std::vector<Pose3> poses{Step(2, 0.5)};
  for (int side = 0; side < 4; ++side) {
    const double slope = side == 0 ? -0.05 : side == 2 ? 0.05 : 0;
    for (int i = 0; i < 10; ++i) {
      const double turn = i == 9 ? M_PI / 2 : 0;
      const double pitch = i == 0 ? slope : i == 9 ? -slope : 0;
      // The pitch ends before the turn begins.
      poses.push_back(poses.back() * Step(1, 0, pitch) * Step(0, turn));
    }
  }
  return poses;
}

inline Matrix6 OfSteps() { return InformationOf(0.02, 0.01); }
inline Matrix6 OfClosures() { return InformationOf(0.03, 0.01); }

// What odometry measures of step i: a little too far, and twisted.
inline Pose3 Measured(const std::vector<Pose3>& truth, std::size_t i, double twist = 0.006) {
  return truth[i - 1].inverse() * truth[i] * Step(0.01, twist, twist / 10);
}

inline Link Closing(const std::vector<Pose3>& truth, std::uint32_t from, std::uint32_t to) {
  return {from, to, truth[from].inverse() * truth[to], OfClosures(), LinkKind::kPicture};
}

// How far the poses are off at most, as seen from the first one [m].
inline double WorstOf(const std::vector<Pose3>& poses, const std::vector<Pose3>& truth) {
  const Pose3 moved = truth[0] * poses[0].inverse();
  double worst = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    worst = std::max(worst, ((moved * poses[i]).translation() - truth[i].translation()).norm());
  }
  return worst;
}

}  // namespace coppice::robot::slam

#endif  // COPPICE_TESTS_ROBOT_APP_SLAM_GRAPH_RING_H_
