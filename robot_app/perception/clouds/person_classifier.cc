#include "robot_app/perception/clouds/person_classifier.h"

namespace coppice::robot::perception {
namespace {

constexpr BoostedTrees::Subject kSubject{"person_classifier", kFeatures, "people"};

}  // namespace

Expected<PersonClassifier> PersonClassifier::Train(const std::vector<Example>& examples,
                                                   const Training& training) {
  std::vector<BoostedTrees::Example> rows;
  rows.reserve(examples.size());
  for (const Example& example : examples) {
    rows.push_back({{example.features.begin(), example.features.end()}, example.is_person});
  }
  auto trees = BoostedTrees::Train(kSubject, rows, training);
  if (!trees) return Problem{trees.problem()};
  return PersonClassifier(*std::move(trees));
}

Expected<PersonClassifier> PersonClassifier::Load(const std::string& file) {
  auto trees = BoostedTrees::Load(file, kSubject);
  if (!trees) return Problem{trees.problem()};
  return PersonClassifier(*std::move(trees));
}

}  // namespace coppice::robot::perception
