// How good a map of several sessions becomes: rounds through a simulated floor, each begun
// anywhere, with other people, other doors and other light, given to the mapper as the robot would.
#ifndef COPPICE_ROBOT_APP_TRAINING_SLAM_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_SLAM_FIGURES_H_

#include <functional>
#include <string>
#include <vector>

#include "robot_app/slam/map/slam_mapper.h"
#include "robot_app/training/slam_tour.h"

namespace coppice::robot::training {

struct SlamStudy {
  const simulation::Floor& floor;
  const RobotSensors& sensors;
  const slam::Vocabulary& vocabulary;
  const slam::PlaceClassifier& classifier;
  std::vector<simulation::Vec2> way;
  std::vector<double> lights;  ///< a session with each
  std::uint64_t seed = 1;
  slam::MapperSettings mapper;
  bool on_disk = false;  ///< what is not worked with is in a store
};

struct SlamFigures {
  double way = 0;  ///< of all sessions [m]
  int key_frames = 0;
  int by_picture = 0, by_cloud = 0;  ///< closures that were believed
  int from_disk = 0;                 ///< of them, to key frames that had been put away before
  int refused = 0;
  int false_closures = 0;  ///< believed, and more than 0.5 m or 5 degrees off
  int joined = 0;          ///< sessions that were joined in their round, of those after the first
  double error = 0;  ///< of the trajectories, root of mean square after one shift and turn [m]
  double worst = 0;  ///< [m]
  double right_cells = 0;        ///< share of the grid's known cells that are as on the floor
  std::size_t most_working = 0;  ///< key frames in memory
  double mean_update = 0, worst_update = 0;  ///< of a processor [s]
};

/// What the study leaves.
struct SlamResult {
  SlamFigures figures;
  slam::SlamMap map;
  std::vector<Stop> stops;  ///< of each key frame
};

/// Drives all sessions. `say` hears how far it is, 0..1.
SlamResult MeasureSlam(const SlamStudy& study, const std::function<void(double)>& say);

std::string Table(const std::vector<SlamFigures>& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_SLAM_FIGURES_H_
