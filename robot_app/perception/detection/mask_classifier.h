// Tells faces from all else, and faces with a mask from faces without: linear support vector
// machines of OpenCV (Vapnik 1995), learnt from generated pictures by `coppice-train masks`.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_CLASSIFIER_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot::perception {

/// A plane between two kinds: weights of the features, and an offset at the end.
using Plane = std::vector<float>;

/// How far the features are on its first side; below 0 on the other. Features may be more than
/// weights.
float Margin(const Plane& plane, const std::vector<float>& features);

struct MaskClassifier {
  Plane face;  ///< of a face's histograms: a face, or something else
  Plane mask;  ///< of all features: with a mask, or without
};

/// Reads the file that Save() wrote. A file that is missing, damaged or made for other features is
/// a problem.
Expected<MaskClassifier> LoadMaskClassifier(const std::string& file);
Outcome Save(const MaskClassifier& classifier, const std::string& file);

/// An example and its side.
struct FaceExample {
  std::vector<float> features;
  bool is_first = false;
};

/// Learns from the first `count` features of at least one example of each side. The same examples
/// give the same plane.
Expected<Plane> LearnPlane(const std::vector<FaceExample>& examples, int count);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_MASK_CLASSIFIER_H_
