// How good a detector for pictures is: precision, recall and average precision, as in the PASCAL
// VOC challenge (Everingham et al., IJCV 2010; the area under the whole curve, as since 2010).
#ifndef COPPICE_ROBOT_APP_TRAINING_DETECTION_FIGURES_H_
#define COPPICE_ROBOT_APP_TRAINING_DETECTION_FIGURES_H_

#include <utility>
#include <vector>

#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::training {

inline constexpr double kSameThing = 0.5;  ///< Overlap of a box with the true one, at least

/// Of one kind of thing, over many pictures.
class DetectionFigures {
 public:
  /// A picture: what is there and what was seen, all of the kind. What is there with confidence 0
  /// may be seen or not, that counts neither way. Of several boxes for one thing the surest is
  /// right, all others are wrong.
  void Add(const std::vector<perception::Sighting>& truth, std::vector<perception::Sighting> seen);

  int there() const { return there_; }
  int found(double least_confidence) const;
  int invented(double least_confidence) const;
  double precision(double least_confidence) const;
  double recall(double least_confidence) const;
  double average_precision() const;

 private:
  int there_ = 0;
  std::vector<std::pair<double, bool>> seen_;  // confidence, right
};

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_DETECTION_FIGURES_H_
