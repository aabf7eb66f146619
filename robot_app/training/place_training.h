// `coppice-train places`: when two turns of the lidar were measured at one place, learnt from pairs
// of turns in halls that nobody built.
#ifndef COPPICE_ROBOT_APP_TRAINING_PLACE_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_PLACE_TRAINING_H_

#include <cstdint>
#include <functional>

#include "bt_core/base/outcome.h"
#include "robot_app/slam/clouds/cloud_places.h"

namespace coppice::robot::training {

struct PlaceTrainingOptions {
  std::uint64_t seed = 1;
  int halls = 300;  ///< with eight turns in each, people walking between them
};

/// `say` hears how far it is, 0..1. The same options give the same classifier.
Expected<slam::PlaceClassifier> TrainPlaces(const PlaceTrainingOptions& options,
                                            const std::function<void(double)>& say);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_PLACE_TRAINING_H_
