// How long the mapper takes for an update of a large map: what the sensors saw on some rounds is
// given to it again and again, each time as a session of its own with odometry that drifts
// otherwise, until the map is as large as it shall be.
#ifndef COPPICE_ROBOT_APP_TRAINING_MAPS_UPDATE_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_MAPS_UPDATE_FIGURES_H_

#include <functional>
#include <string>
#include <vector>

#include "robot_app/training/slam_figures.h"

namespace coppice::robot::training {

/// Of some hundred updates in a row: corners of the pictures, recognition, pose graph, disk.
struct UpdateFigures {
  std::size_t key_frames = 0;              ///< of the map after them
  std::size_t working = 0;                 ///< of those, in memory
  int closures = 0;                        ///< that were believed
  std::size_t most_poses = 0;              ///< that were solved in an update
  double median = 0, late = 0, worst = 0;  ///< of a processor; late: the slowest but 1 % [s]
  double memory = 0;                       ///< of the whole program [MB]
};

/// Until the map has so many key frames; figures for each `every` of them. What is not worked with
/// is on the disk.
std::vector<UpdateFigures> MeasureUpdates(const SlamStudy& study, std::size_t key_frames,
                                          std::size_t every,
                                          const std::function<void(double)>& say);

std::string Table(const std::vector<UpdateFigures>& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_MAPS_UPDATE_FIGURES_H_
