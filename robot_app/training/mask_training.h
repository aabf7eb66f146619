// Learns to find faces and to tell those with a mask from those without, from generated pictures,
// and says how well it does on others.
#ifndef COPPICE_ROBOT_APP_TRAINING_MASK_TRAINING_H_
#define COPPICE_ROBOT_APP_TRAINING_MASK_TRAINING_H_

#include <cstdint>
#include <functional>
#include <string>

#include "robot_app/perception/detection/detector.h"
#include "robot_app/perception/detection/mask_classifier.h"
#include "robot_app/training/detection_figures.h"

namespace coppice::robot::training {

struct MaskTrainingOptions {
  std::uint64_t seed = 1;
  int pictures = 600;  ///< as many as the robot of the paper learnt from
  int rounds = 3;      ///< each after the first learns also from what the one before took for faces
};

/// `say` is told how far it is, 0..1. The same options give the same classifier.
Expected<perception::MaskClassifier> TrainMasks(const MaskTrainingOptions& options,
                                                const std::function<void(double)>& say);

struct MaskFigures {
  DetectionFigures with_mask, without_mask;
  int pictures = 0;
  double seconds = 0;  ///< of looking, all pictures
};

/// What `detector` sees in `pictures` pictures of another seed.
MaskFigures MeasureMasks(perception::Detector& detector, int pictures, std::uint64_t seed,
                         bool with_depth);

/// A table for people, Markdown, with the figures of the paper (S118) beside.
std::string Table(const MaskFigures& figures);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_MASK_TRAINING_H_
