#include "robot_app/perception/legs/leg_classifier.h"

namespace coppice::robot::perception {
namespace {

constexpr BoostedTrees::Subject kSubject{"leg_classifier", kLegFeatures, "legs"};

}  // namespace

Expected<LegClassifier> LegClassifier::Train(const std::vector<Example>& examples,
                                             const Training& training) {
  std::vector<BoostedTrees::Example> rows;
  rows.reserve(examples.size());
  for (const Example& example : examples) {
    rows.push_back({{example.features.begin(), example.features.end()}, example.is_person});
  }
  auto trees = BoostedTrees::Train(kSubject, rows, training);
  if (!trees) return Problem{trees.problem()};
  return LegClassifier(*std::move(trees));
}

Expected<LegClassifier> LegClassifier::Load(const std::string& file) {
  auto trees = BoostedTrees::Load(file, kSubject);
  if (!trees) return Problem{trees.problem()};
  return LegClassifier(*std::move(trees));
}

}  // namespace coppice::robot::perception
