#include "robot_app/common/learning/boosted_trees.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/ml.hpp>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot {

struct BoostedTrees::Trees {
  Subject subject;
  cv::Ptr<cv::ml::Boost> boost = cv::ml::Boost::create();
};

BoostedTrees::BoostedTrees(std::unique_ptr<Trees> trees) : trees_(std::move(trees)) {}
BoostedTrees::BoostedTrees(BoostedTrees&&) noexcept = default;
BoostedTrees& BoostedTrees::operator=(BoostedTrees&&) noexcept = default;
BoostedTrees::~BoostedTrees() = default;

Expected<BoostedTrees> BoostedTrees::Train(const Subject& subject,
                                           const std::vector<Example>& examples,
                                           const Training& training) {
  cv::Mat rows(static_cast<int>(examples.size()), subject.features, CV_32F);
  cv::Mat kinds(static_cast<int>(examples.size()), 1, CV_32S);
  int ones = 0;
  for (int i = 0; i < rows.rows; ++i) {
    const Example& example = examples[static_cast<std::size_t>(i)];
    std::copy(example.features.begin(), example.features.end(), rows.ptr<float>(i));
    kinds.at<int>(i) = example.is_one ? 1 : 0;
    ones += kinds.at<int>(i);
  }
  if (ones == 0 || ones == rows.rows) {
    return Problem{"to learn, examples of both kinds are needed; there are " +
                   std::to_string(ones) + " " + subject.train + " among " +
                   std::to_string(rows.rows)};
  }
  auto trees = std::make_unique<Trees>();
  trees->subject = subject;
  trees->boost->setBoostType(cv::ml::Boost::GENTLE);
  trees->boost->setWeakCount(training.trees);
  trees->boost->setMaxDepth(training.depth);
  trees->boost->setWeightTrimRate(0);
  trees->boost->train(rows, cv::ml::ROW_SAMPLE, kinds);
  return BoostedTrees(std::move(trees));
}

Outcome BoostedTrees::Save(const std::string& file) const {
  cv::FileStorage storage(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << trees_->subject.name << "{"
          << "features" << trees_->subject.features;
  trees_->boost->write(storage);
  storage << "}";
  Diagnostics diagnostics;
  if (WriteFile(file, storage.releaseAndGetString(), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<BoostedTrees> BoostedTrees::Load(const std::string& file, const Subject& subject) {
  const auto text = ReadFile(file);
  if (!text) return Problem{file + ": cannot be read"};
  try {
    const cv::FileStorage storage(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode node = storage[subject.name];
    auto trees = std::make_unique<Trees>();
    trees->subject = subject;
    if (!node.empty() && static_cast<int>(node["features"]) == subject.features) {
      trees->boost->read(node);
      if (trees->boost->isTrained()) return BoostedTrees(std::move(trees));
    }
  } catch (const std::exception&) {
    // OpenCV's text tells of its own sources; its parser also lets those of the strings through
  }
  return Problem{file + ": expected a classifier of " + std::to_string(subject.features) +
                 " features, as `coppice-train " + subject.train + "` writes it"};
}

float BoostedTrees::Probability(const float* features) const {
  const cv::Mat row(1, trees_->subject.features, CV_32F, const_cast<float*>(features));
  const float sum = trees_->boost->predict(row, cv::noArray(), cv::ml::DTrees::PREDICT_SUM);
  return 1 / (1 + std::exp(-2 * sum));
}

}  // namespace coppice::robot
