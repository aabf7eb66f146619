// Tells legs of people in scans of a planar laser from all else: boosted decision trees of OpenCV,
// learnt from simulated scans by `coppice-train legs`.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_

#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/learning/boosted_trees.h"
#include "robot_app/perception/legs/leg_features.h"

namespace coppice::robot::perception {

/// Movable. Probability() may be called by several threads.
class LegClassifier {
 public:
  /// Reads the file that Save() wrote. A file that is missing, damaged or made for other features
  /// is a problem.
  static Expected<LegClassifier> Load(const std::string& file);

  struct Example {
    LegFeatures features;
    bool is_person = false;
  };
  using Training = BoostedTrees::Training;
  /// Learns from at least one example of each kind; the same examples give the same classifier.
  static Expected<LegClassifier> Train(const std::vector<Example>& examples,
                                       const Training& training);

  Outcome Save(const std::string& file) const { return trees_.Save(file); }

  /// 0..1: how sure it is that these are the legs of one person.
  float Probability(const LegFeatures& features) const {
    return trees_.Probability(features.data());
  }

 private:
  explicit LegClassifier(BoostedTrees trees) : trees_(std::move(trees)) {}
  BoostedTrees trees_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_LEGS_LEG_CLASSIFIER_H_
