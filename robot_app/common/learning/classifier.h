// Boosted decision trees that tell one kind of thing from all others by its features. What the kind
// is, a type says:
//
//   struct LegKind {
//     using Features = LegFeatures;  // std::array<float, N>
//     static constexpr BoostedTrees::Subject kSubject{"leg_classifier", kLegFeatures, "legs"};
//   };
//   using LegClassifier = Classifier<LegKind>;
//   const auto classifier = LegClassifier::Load("legs.yaml");
//   classifier->Probability(features);
#ifndef COPPICE_ROBOT_APP_COMMON_LEARNING_CLASSIFIER_H_
#define COPPICE_ROBOT_APP_COMMON_LEARNING_CLASSIFIER_H_

#include <string>
#include <utility>
#include <vector>

#include "robot_app/common/learning/boosted_trees.h"

namespace coppice::robot {

/// Movable. Probability() may be called by several threads.
template <class Kind>
class Classifier {
 public:
  using Features = typename Kind::Features;
  struct Example {
    Features features;
    bool is_one = false;  ///< of the kind
  };

  /// Reads the file that Save() wrote. A file that is missing, damaged or made for other features
  /// is a problem.
  static Expected<Classifier> Load(const std::string& file) {
    return Of(BoostedTrees::Load(file, Kind::kSubject));
  }

  /// Learns from at least one example of the kind and one of another; the same examples give the
  /// same classifier.
  static Expected<Classifier> Train(const std::vector<Example>& examples,
                                    const BoostedTrees::Training& training = {}) {
    std::vector<BoostedTrees::Example> rows;
    rows.reserve(examples.size());
    for (const Example& example : examples) {
      rows.push_back({{example.features.begin(), example.features.end()}, example.is_one});
    }
    return Of(BoostedTrees::Train(Kind::kSubject, rows, training));
  }

  Outcome Save(const std::string& file) const { return trees_.Save(file); }

  /// 0..1: how sure it is that these are features of one of the kind.
  float Probability(const Features& features) const { return trees_.Probability(features.data()); }

 private:
  explicit Classifier(BoostedTrees trees) : trees_(std::move(trees)) {}
  static Expected<Classifier> Of(Expected<BoostedTrees> trees) {
    if (!trees) return Problem{trees.problem()};
    return Classifier(*std::move(trees));
  }

  BoostedTrees trees_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LEARNING_CLASSIFIER_H_
