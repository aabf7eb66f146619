// Tells clusters that are people from all others; learnt from simulated scans by
// `coppice-train people`.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_

#include "robot_app/common/learning/classifier.h"
#include "robot_app/perception/clouds/features.h"

namespace coppice::robot::perception {

struct PersonKind {
  using Features = perception::Features;
  static constexpr BoostedTrees::Subject kSubject{"person_classifier", kFeatures, "people"};
};

/// One of the kind: this cluster is a person.
using PersonClassifier = Classifier<PersonKind>;

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_
