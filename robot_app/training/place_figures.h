// How well places are recognized, in pictures and in clouds: one round in full light is remembered,
// and on others, aside of its way, with other people, other doors and less light, the robot asks at
// each stop where it is.
#ifndef COPPICE_ROBOT_APP_TRAINING_PLACE_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_PLACE_FIGURES_H_

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "robot_app/slam/clouds/cloud_places.h"
#include "robot_app/slam/pictures/vocabulary.h"
#include "robot_app/training/slam_tour.h"

namespace coppice::robot::training {

struct PlaceFigures {
  double light = 1;
  int asked = 0;           ///< stops
  int answered = 0;        ///< of them: a place was sure
  int wrong = 0;           ///< of those: more than 0.5 m or 5 degrees off
  double error = 0;        ///< of the right ones, root of mean square [m]
  double farthest = 0;     ///< that a sure one is off, right or wrong [m]
  double seconds = 0;      ///< of a processor, to look for places at all stops
  double least_right = 0;  ///< the least sure place that is right: inliers, or overlap
  double most_wrong = 0;   ///< the surest that is wrong, sure enough or not

  double recall() const { return asked > 0 ? static_cast<double>(answered - wrong) / asked : 0; }
};

/// Where it is measured.
struct PlaceStudy {
  const simulation::Floor& floor;
  const RobotSensors& sensors;
  std::vector<simulation::Vec2> way;
  std::vector<double> lights;  ///< a round with each
  std::uint64_t seed = 1;
  /// Of clouds: only places are asked for that are so near to where the robot is [m], and its turn
  /// is known that well [rad]; what is said of it is wrong by a quarter of that.
  double doubt = 1e9;
  double turn_doubt = M_PI;
};

/// `say` hears how far it is, 0..1.
std::vector<PlaceFigures> MeasurePictures(const slam::Vocabulary& vocabulary,
                                          const PlaceStudy& study,
                                          const std::function<void(double)>& say);
std::vector<PlaceFigures> MeasureClouds(const slam::PlaceClassifier& classifier,
                                        const PlaceStudy& study,
                                        const std::function<void(double)>& say);

std::string Table(const std::vector<PlaceFigures>& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PLACE_FIGURES_H_
