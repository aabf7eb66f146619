#include "robot_app/common/learning/boosted_trees.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <opencv2/ml.hpp>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/learning/flat_yaml.h"

namespace coppice::robot {

namespace {

constexpr std::size_t kLongestFile = std::size_t{4} << 20;  // ten times what is shipped
constexpr std::size_t kDeepest = 16;                        // levels of a tree

// Of a tree in preorder: what is not more than the threshold goes to the node behind it.
struct Node {
  int feature = -1;  // none: a leaf
  float threshold = 0;
  float value = 0;
  std::size_t other = 0;  // where the rest goes
};

// The file is read by OpenCV and understood here: OpenCV itself believes whatever numbers it holds.
class Reader {
 public:
  explicit Reader(int features) : features_(features) {}

  std::vector<Node> nodes;
  std::vector<std::size_t> roots;

  // False if it is damaged.
  bool Read(const cv::FileNode& trees) {
    for (const cv::FileNode& tree : trees) {
      roots.push_back(nodes.size());
      if (!ReadTree(tree["nodes"])) return false;
    }
    return !roots.empty();
  }

 private:
  bool ReadTree(const cv::FileNode& told) {
    std::vector<std::size_t> open;  // nodes whose other side is still to come
    bool is_whole = false;
    for (const cv::FileNode& node : told) {
      if (is_whole || !ReadNode(node)) return false;
      if (nodes.back().feature >= 0) {
        open.push_back(nodes.size() - 1);
        if (open.size() > kDeepest) return false;
      } else if (open.empty()) {
        is_whole = true;
      } else {
        nodes[open.back()].other = nodes.size();
        open.pop_back();
      }
    }
    return is_whole;
  }

  bool ReadNode(const cv::FileNode& told) {
    Node node;
    if (!ReadNumber(told["value"], node.value)) return false;
    const cv::FileNode splits = told["splits"];
    if (!splits.empty()) {
      const cv::FileNode split = *splits.begin();
      const cv::FileNode feature = split["var"];
      if (!feature.isInt() || !ReadNumber(split["le"], node.threshold)) return false;
      node.feature = static_cast<int>(feature);
      if (node.feature < 0 || node.feature >= features_) return false;
    }
    nodes.push_back(node);
    return true;
  }

  static bool ReadNumber(const cv::FileNode& told, float& number) {
    if (!told.isReal() && !told.isInt()) return false;
    number = static_cast<float>(told);
    return std::isfinite(number);
  }

  const int features_;
};

}  // namespace

struct BoostedTrees::Trees {
  int features;
  std::string text;  // of the file
  std::vector<Node> nodes;
  std::vector<std::size_t> roots;

  // Nothing if the text is damaged, or of something else.
  static std::unique_ptr<Trees> From(std::string text, const Subject& subject) {
    if (!IsFlatYaml(text)) return nullptr;
    Reader reader(subject.features);
    try {
      const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
      const cv::FileNode node = storage[subject.name];
      const bool fits = node.isMap() && static_cast<int>(node["features"]) == subject.features;
      if (!fits || !reader.Read(node["trees"])) return nullptr;
      // Else the rest was cut off.
      if (static_cast<int>(node["ntrees"]) != static_cast<int>(reader.roots.size())) return nullptr;
    } catch (const std::exception&) {
      return nullptr;  // its text tells of OpenCV's own sources
    }
    return std::make_unique<Trees>(
        Trees{subject.features, std::move(text), std::move(reader.nodes), std::move(reader.roots)});
  }
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
  const cv::Ptr<cv::ml::Boost> boost = cv::ml::Boost::create();
  boost->setBoostType(cv::ml::Boost::GENTLE);
  boost->setWeakCount(training.trees);
  boost->setMaxDepth(training.depth);
  boost->setWeightTrimRate(0);
  boost->train(rows, cv::ml::ROW_SAMPLE, kinds);
  cv::FileStorage storage(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << subject.name << "{"
          << "features" << subject.features;
  boost->write(storage);
  storage << "}";
  auto trees = Trees::From(storage.releaseAndGetString(), subject);
  if (trees) return BoostedTrees(std::move(trees));
  return Problem{"nothing could be learnt"};
}

Outcome BoostedTrees::Save(const std::string& file) const {
  Diagnostics diagnostics;
  if (WriteFile(file, trees_->text, diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<BoostedTrees> BoostedTrees::Load(const std::string& file, const Subject& subject) {
  auto text = ReadFile(file, kLongestFile);
  if (!text) return Problem{file + ": cannot be read"};
  auto trees = Trees::From(*std::move(text), subject);
  if (trees) return BoostedTrees(std::move(trees));
  return Problem{file + ": expected a classifier of " + std::to_string(subject.features) +
                 " features, as `coppice-train " + subject.train + "` writes it"};
}

float BoostedTrees::Probability(const float* features) const {
  float sum = 0;
  for (std::size_t at : trees_->roots) {
    const Node* node = &trees_->nodes[at];
    while (node->feature >= 0) {
      node = features[node->feature] <= node->threshold ? node + 1 : &trees_->nodes[node->other];
    }
    sum += node->value;
  }
  return 1 / (1 + std::exp(-2 * sum));
}

}  // namespace coppice::robot
