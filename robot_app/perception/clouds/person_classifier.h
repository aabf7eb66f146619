// Tells clusters that are people from all others: boosted decision trees of OpenCV, learnt from
// simulated scans by `coppice-train people`.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_

#include <string>
#include <utility>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/learning/boosted_trees.h"
#include "robot_app/perception/clouds/features.h"

namespace coppice::robot::perception {

/// Movable. Probability() may be called by several threads.
class PersonClassifier {
 public:
  /// Reads the file that Save() wrote. A file that is missing, damaged or made for other features
  /// is a problem.
  static Expected<PersonClassifier> Load(const std::string& file);

  struct Example {
    Features features;
    bool is_person = false;
  };
  using Training = BoostedTrees::Training;
  /// Learns from at least one example of each kind; the same examples give the same classifier.
  static Expected<PersonClassifier> Train(const std::vector<Example>& examples,
                                          const Training& training);

  Outcome Save(const std::string& file) const { return trees_.Save(file); }

  /// 0..1: how sure it is that these are features of a person.
  float Probability(const Features& features) const { return trees_.Probability(features.data()); }

 private:
  explicit PersonClassifier(BoostedTrees trees) : trees_(std::move(trees)) {}
  BoostedTrees trees_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_PERSON_CLASSIFIER_H_
