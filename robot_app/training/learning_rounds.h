// Learning in rounds: the first learns from all that is of the kind and a little of all else, each
// later one also from what the one before was not sure about.
#ifndef COPPICE_ROBOT_APP_TRAINING_LEARNING_ROUNDS_H_
#define COPPICE_ROBOT_APP_TRAINING_LEARNING_ROUNDS_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include "robot_app/common/learning/classifier.h"

namespace coppice::robot::training {

struct LearningRounds {
  std::uint64_t seed = 1;
  int scans = 700;  ///< of a round, each in a hall of its own
  int rounds = 3;
  BoostedTrees::Training trees;
};

/// Told how far something is, 0..1.
using Progress = std::function<void(double)>;

/// `examples_in(random)` makes the examples of the next scan. The same rounds and examples give the
/// same classifier.
template <class Kind, class ExamplesIn>
Expected<Classifier<Kind>> LearnInRounds(const LearningRounds& learning, ExamplesIn examples_in,
                                         const Progress& say) {
  using Example = typename Classifier<Kind>::Example;
  constexpr float kSuspicious = 0.1F;  // later rounds learn from what looks like one
  constexpr int kEverydayShare = 8;    // and from each eighth of what is clear
  std::mt19937_64 random(learning.seed);
  std::vector<Example> examples;
  std::optional<Classifier<Kind>> classifier;
  const auto is_everyday = [&](const Example& example) {
    if (!classifier) return !example.is_one;
    const float probability = classifier->Probability(example.features);
    return example.is_one ? probability >= 1 - kSuspicious : probability <= kSuspicious;
  };
  for (int round = 0; round < learning.rounds; ++round) {
    for (int i = 0; i < learning.scans; ++i) {
      for (const Example& example : examples_in(random)) {
        if (is_everyday(example) && random() % kEverydayShare != 0) continue;
        examples.push_back(example);
      }
      say((round + static_cast<double>(i) / learning.scans) / learning.rounds);
    }
    auto learnt = Classifier<Kind>::Train(examples, learning.trees);
    if (!learnt) return Problem{learnt.problem()};
    classifier.emplace(std::move(*learnt));
  }
  return std::move(*classifier);
}

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LEARNING_ROUNDS_H_
