// Tells legs of people in scans of a planar laser from all else; learnt from simulated scans by
// `coppice-train legs`.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_

#include "robot_app/common/learning/classifier.h"
#include "robot_app/perception/legs/leg_features.h"

namespace coppice::robot::perception {

struct LegKind {
  using Features = LegFeatures;
  static constexpr BoostedTrees::Subject kSubject{"leg_classifier", kLegFeatures, "legs"};
};

/// One of the kind: these are the legs of one person.
using LegClassifier = Classifier<LegKind>;

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_
