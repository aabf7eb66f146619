// Rounds through a building that nobody built, as poses and links alone: what a pose graph of many
// sessions gets to solve, in no time and of any size.
#ifndef COPPICE_ROBOT_APP_TRAINING_MAPS_BUILDING_TOUR_H_
#define COPPICE_ROBOT_APP_TRAINING_MAPS_BUILDING_TOUR_H_

#include <cstdint>
#include <string>
#include <vector>

#include "robot_app/slam/graph/session_graph.h"

namespace coppice::robot::training {

struct BuildingTourSettings {
  std::uint64_t seed = 1;
  int key_frames = 1000;  ///< of a session
  int sessions = 5;
  double step = 0.5;        ///< between key frames [m]
  double recognized = 0.6;  ///< share of the key frames at a known place that close a loop
  double twist = 0.0005;    ///< odometry turns so much too far at each step [rad]
};

/// One thing that happens to a graph: a key frame, and what closed there.
struct TourStep {
  bool begins = false;  ///< a session
  slam::Pose3 truth = slam::Pose3::Identity();
  slam::Pose3 moved = slam::Pose3::Identity();  ///< as odometry says
  slam::Matrix6 information = slam::Matrix6::Identity();
  std::vector<slam::Link> closures;
};

struct GraphFigures {
  std::size_t key_frames = 0;
  std::size_t links = 0;
  int believed = 0, refused = 0, waited = 0;  ///< closures
  // Of an update: a key frame, its closures and what is refined after them.
  std::size_t most_poses = 0, most_links = 0;  ///< that were solved
  double median = 0, worst = 0;                ///< of the last quarter, of a processor [s]
  double error = 0;          ///< of the ways, root of mean square after one shift and turn [m]
  double error_at_once = 0;  ///< the same once all poses were solved at once from there [m]
};

/// Corridors of 60 m by 40 m with a way across; each session begins elsewhere and turns at random.
std::vector<TourStep> TourOfABuilding(const BuildingTourSettings& settings);

/// Drives it through a graph.
GraphFigures MeasureGraph(const std::vector<TourStep>& tour, slam::SessionGraphSettings settings);

std::string Table(const std::vector<GraphFigures>& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_MAPS_BUILDING_TOUR_H_
