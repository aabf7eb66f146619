#include "robot_app/perception/clouds/person_classifier.h"

#include <cmath>
#include <exception>
#include <opencv2/ml.hpp>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::perception {

struct PersonClassifier::Trees {
  cv::Ptr<cv::ml::Boost> boost;
};

namespace {

constexpr char kNode[] = "person_classifier";

cv::Mat RowOf(const Features& features) {
  return {1, kFeatures, CV_32F, const_cast<float*>(features.data())};
}

}  // namespace

PersonClassifier::PersonClassifier(std::unique_ptr<Trees> trees) : trees_(std::move(trees)) {}
PersonClassifier::PersonClassifier(PersonClassifier&&) noexcept = default;
PersonClassifier& PersonClassifier::operator=(PersonClassifier&&) noexcept = default;
PersonClassifier::~PersonClassifier() = default;

Expected<PersonClassifier> PersonClassifier::Train(const std::vector<Example>& examples,
                                                   const Training& training) {
  cv::Mat rows(static_cast<int>(examples.size()), kFeatures, CV_32F);
  cv::Mat kinds(static_cast<int>(examples.size()), 1, CV_32S);
  int people = 0;
  for (int i = 0; i < rows.rows; ++i) {
    RowOf(examples[i].features).copyTo(rows.row(i));
    kinds.at<int>(i) = examples[i].is_person ? 1 : 0;
    people += kinds.at<int>(i);
  }
  if (people == 0 || people == rows.rows) {
    return Problem{"to learn, examples of both kinds are needed; there are " +
                   std::to_string(people) + " people among " + std::to_string(rows.rows)};
  }
  auto trees = std::make_unique<Trees>();
  trees->boost = cv::ml::Boost::create();
  trees->boost->setBoostType(cv::ml::Boost::GENTLE);
  trees->boost->setWeakCount(training.trees);
  trees->boost->setMaxDepth(training.depth);
  trees->boost->setWeightTrimRate(0);
  trees->boost->train(rows, cv::ml::ROW_SAMPLE, kinds);
  return PersonClassifier(std::move(trees));
}

Outcome PersonClassifier::Save(const std::string& file) const {
  cv::FileStorage storage(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << kNode << "{"
          << "features" << kFeatures;
  trees_->boost->write(storage);
  storage << "}";
  Diagnostics diagnostics;
  if (WriteFile(file, storage.releaseAndGetString(), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<PersonClassifier> PersonClassifier::Load(const std::string& file) {
  const auto text = ReadFile(file);
  if (!text) return Problem{file + ": cannot be read"};
  try {
    const cv::FileStorage storage(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode node = storage[kNode];
    auto trees = std::make_unique<Trees>();
    trees->boost = cv::ml::Boost::create();
    if (!node.empty() && static_cast<int>(node["features"]) == kFeatures) {
      trees->boost->read(node);
      if (trees->boost->isTrained()) return PersonClassifier(std::move(trees));
    }
  } catch (const std::exception&) {
    // OpenCV's text tells of its own sources; its parser also lets those of the strings through
  }
  return Problem{file + ": expected a classifier of " + std::to_string(kFeatures) +
                 " features, as `coppice-train people` writes it"};
}

float PersonClassifier::Probability(const Features& features) const {
  const float sum =
      trees_->boost->predict(RowOf(features), cv::noArray(), cv::ml::DTrees::PREDICT_SUM);
  return 1 / (1 + std::exp(-2 * sum));
}

}  // namespace coppice::robot::perception
