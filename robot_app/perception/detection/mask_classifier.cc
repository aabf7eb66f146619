#include "robot_app/perception/detection/mask_classifier.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numeric>
#include <opencv2/ml.hpp>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "robot_app/common/learning/flat_yaml.h"
#include "robot_app/perception/detection/face_window.h"

namespace coppice::robot::perception {
namespace {

constexpr char kNode[] = "faces_and_masks";
constexpr double kSoftness = 0.1;  // C: how dear an example on the wrong side is
constexpr int kSteps = 30000;
constexpr double kClose = 1e-3;

bool IsWhole(const Plane& plane, int features) {
  return static_cast<int>(plane.size()) == features + 1 &&
         std::all_of(plane.begin(), plane.end(), [](float x) { return std::isfinite(x); });
}

Plane PlaneOf(const cv::ml::SVM& machine) {
  const cv::Mat vector = machine.getSupportVectors();  // one, because the kernel is linear
  std::vector<float> weights, indices;
  const double offset = machine.getDecisionFunction(0, weights, indices);
  Plane plane(vector.ptr<float>(), vector.ptr<float>() + vector.cols);
  plane.push_back(static_cast<float>(-offset));
  return plane;
}

}  // namespace

float Margin(const Plane& plane, const std::vector<float>& features) {
  return std::inner_product(plane.begin(), plane.end() - 1, features.begin(), plane.back());
}

Expected<Plane> LearnPlane(const std::vector<FaceExample>& examples, int count) {
  cv::Mat rows(static_cast<int>(examples.size()), count, CV_32F);
  cv::Mat sides(static_cast<int>(examples.size()), 1, CV_32S);
  int first = 0;
  for (int i = 0; i < rows.rows; ++i) {
    const FaceExample& example = examples[static_cast<std::size_t>(i)];
    std::copy_n(example.features.begin(), count, rows.ptr<float>(i));
    sides.at<int>(i) = example.is_first ? 1 : -1;
    first += example.is_first ? 1 : 0;
  }
  if (first == 0 || first == rows.rows) {
    return Problem{"to learn, examples of both kinds are needed; there are " +
                   std::to_string(first) + " of one kind among " + std::to_string(rows.rows)};
  }
  const auto machine = cv::ml::SVM::create();
  machine->setType(cv::ml::SVM::C_SVC);
  machine->setKernel(cv::ml::SVM::LINEAR);
  machine->setC(kSoftness);
  machine->setTermCriteria({cv::TermCriteria::MAX_ITER + cv::TermCriteria::EPS, kSteps, kClose});
  machine->train(rows, cv::ml::ROW_SAMPLE, sides);
  Plane plane = PlaneOf(*machine);
  // OpenCV does not say which side is which: the examples do.
  double sum = 0;
  for (const FaceExample& example : examples) {
    sum += (example.is_first ? 1.0 / first : -1.0 / (rows.rows - first)) *
           Margin(plane, example.features);
  }
  if (sum < 0) std::transform(plane.begin(), plane.end(), plane.begin(), std::negate<>());
  return plane;
}

Outcome Save(const MaskClassifier& classifier, const std::string& file) {
  cv::FileStorage storage(".yaml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
  storage << kNode << "{"
          << "face" << classifier.face << "mask" << classifier.mask << "}";
  Diagnostics diagnostics;
  if (WriteFile(file, storage.releaseAndGetString(), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<MaskClassifier> LoadMaskClassifier(const std::string& file) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;
  const auto text = ReadFile(file, kLongest);
  if (!text) return Problem{file + ": cannot be read"};
  try {
    if (!IsFlatYaml(*text)) throw std::invalid_argument("nested");
    const cv::FileStorage storage(*text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::FileNode node = storage[kNode];
    MaskClassifier classifier;
    node["face"] >> classifier.face;
    node["mask"] >> classifier.mask;
    if (IsWhole(classifier.face, kFaceShapes) && IsWhole(classifier.mask, kFaceFeatures)) {
      return classifier;
    }
  } catch (const std::exception&) {
    // OpenCV's text tells of its own sources; its parser also lets those of the strings through
  }
  return Problem{file + ": expected a classifier of faces and masks, as `coppice-train masks` " +
                 "writes it"};
}

}  // namespace coppice::robot::perception
