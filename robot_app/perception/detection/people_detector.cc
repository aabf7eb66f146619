#include "robot_app/perception/detection/people_detector.h"

#include <cmath>
#include <opencv2/objdetect.hpp>

#include "robot_app/perception/detection/box_depth.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/perception/detection/suppression.h"

namespace coppice::robot::perception {
namespace {

// The window of 64 x 128 pixels has a border around the person in it.
constexpr double kWide = 0.62;
constexpr double kTall = 0.80;

constexpr double kSmallest = 1.1;  // people, with the error of the boxes [m]
constexpr double kTallest = 2.5;
constexpr double kZoom = 1.05;
constexpr double kPartOfOne = 0.8;  // share of a box in another: legs alone, two people as one
constexpr double kSameOne = 0.4;    // share in common of two boxes for one person

class PeopleDetector : public Detector {
 public:
  PeopleDetector() { hog_.setSVMDetector(cv::HOGDescriptor::getDefaultPeopleDetector()); }

  std::vector<Sighting> Find(const DetectorInput& input) override {
    const cv::Mat gray = Gray(input.colour);
    if (gray.cols < hog_.winSize.width || gray.rows < hog_.winSize.height) return {};
    std::vector<cv::Rect> boxes;
    std::vector<double> weights;
    hog_.detectMultiScale(gray, boxes, weights, 0, cv::Size(8, 8), cv::Size(16, 16), kZoom, 0);
    std::vector<Sighting> sightings;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Box box = Tight(ToBox(boxes[i]));
      if (!HasPersonsSize(input, box)) continue;
      sightings.push_back({SightingKind::kPerson, box, Confidence(weights[i])});
    }
    return Suppress(std::move(sightings), kSameOne, kPartOfOne);
  }

  bool Finds(SightingKind kind) const override { return kind == SightingKind::kPerson; }

 private:
  static Box Tight(const Box& window) {
    const double width = kWide * window.width;
    const double height = kTall * window.height;
    return {window.x + (window.width - width) / 2, window.y + (window.height - height) / 2, width,
            height};
  }

  // As far as depth tells.
  static bool HasPersonsSize(const DetectorInput& input, const Box& box) {
    if (!HasDepth(input)) return true;
    const double tall = box.height / input.focal * MedianDepth(*input.depth, box);
    return tall == 0 || (tall > kSmallest && tall < kTallest);
  }

  // The distance from the border between people and all else becomes a share.
  static double Confidence(double weight) { return 1 / (1 + std::exp(-4 * (weight - 0.55))); }

  cv::HOGDescriptor hog_;
};

}  // namespace

std::unique_ptr<Detector> MakePeopleDetector() { return std::make_unique<PeopleDetector>(); }

}  // namespace coppice::robot::perception
