// Boosted decision trees of OpenCV that tell two kinds apart by a row of numbers, and their file.
//
//   const auto trees = BoostedTrees::Train({"place_classifier", 36, "places"}, examples, {});
//   trees->Save("file.yaml");
//   trees->Probability(row);
#ifndef COPPICE_ROBOT_APP_COMMON_LEARNING_BOOSTED_TREES_H_
#define COPPICE_ROBOT_APP_COMMON_LEARNING_BOOSTED_TREES_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// Movable. Probability() may be called by several threads.
class BoostedTrees {
 public:
  /// What they know.
  struct Subject {
    const char* name;   ///< in the file
    int features;       ///< of an example
    const char* train;  ///< the word after `coppice-train` with which the file is made
  };
  struct Training {
    int trees = 80;
    int depth = 3;
  };
  struct Example {
    std::vector<float> features;
    bool is_one = false;  ///< of the kind that is asked for
  };
  /// Learns from at least one example of each kind; the same examples give the same trees.
  static Expected<BoostedTrees> Train(const Subject& subject, const std::vector<Example>& examples,
                                      const Training& training);

  /// Reads what Save() wrote. A file that is missing, damaged or of another subject is a problem.
  static Expected<BoostedTrees> Load(const std::string& file, const Subject& subject);

  BoostedTrees(BoostedTrees&&) noexcept;
  BoostedTrees& operator=(BoostedTrees&&) noexcept;
  ~BoostedTrees();

  Outcome Save(const std::string& file) const;

  /// 0..1: how sure it is that these `features` (as many as learnt) are of the kind.
  float Probability(const float* features) const;

 private:
  struct Trees;
  explicit BoostedTrees(std::unique_ptr<Trees> trees);
  std::unique_ptr<Trees> trees_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_LEARNING_BOOSTED_TREES_H_
