#include "robot_app/perception/detection/mask_detector.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/perception/detection/box_depth.h"
#include "robot_app/perception/detection/face_window.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/perception/detection/suppression.h"

namespace coppice::robot::perception {
namespace {

constexpr double kZoom = 1.15;         // from one size to the next
constexpr int kStride = 8;             // pixels from window to window
constexpr int kRim = 8;                // pixels that are added around: faces may be cut off
constexpr double kPromising = -1;      // margin of a place around which it is worth looking
constexpr double kLeastMargin = -0.3;  // of a face
constexpr double kSameOne = 0.3;       // share in common of two boxes for one face
constexpr double kFaceMetres = 0.23;   // from the hairline to the chin
constexpr double kSmaller = 0.72;      // a face may be so much smaller than that
constexpr double kLarger = 1.4;
constexpr double kStep = 0.12;  // at least so much farther is what is beside a head [m]

double Share(double margin, double slope) { return 1 / (1 + std::exp(-slope * margin)); }

// In the picture: the middle of a window at `place` in one that was made smaller by `zoom` and has
// a rim.
cv::Point2d MiddleOf(const cv::Point& place, double zoom) {
  return zoom * cv::Point2d(place.x - kRim + kFaceWindow.width / 2.0,
                            place.y - kRim + kFaceWindow.height / 2.0);
}

// The depth picture of what is looked at.
class HeadSizes {
 public:
  explicit HeadSizes(const DetectorInput& input) : depth_(*input.depth), focal_(input.focal) {}

  // In a picture that was made smaller by `zoom`: around all windows in which a head may be.
  cv::Rect Area(const cv::Size& size, double zoom) const {
    cv::Rect area;
    for (int y = 0; y + kFaceWindow.height <= size.height; y += kStride) {
      for (int x = 0; x + kFaceWindow.width <= size.width; x += kStride) {
        if (Fits({x, y}, zoom)) area |= cv::Rect({x, y}, kFaceWindow);
      }
    }
    return area;
  }

  // Could there be a head in the window at `place` of such a picture?
  bool Fits(const cv::Point& place, double zoom) const {
    const double tall = zoom * kFaceTall;
    const cv::Point2d middle = MiddleOf(place, zoom);
    const double near = Nearest(middle, tall / 8);
    if (near <= 0) return false;
    const double usual = focal_ * kFaceMetres / near;
    if (tall < kSmaller * usual || tall > kLarger * usual) return false;
    return IsFarther(middle + cv::Point2d(-0.7 * tall, -0.5 * tall), near) ||
           IsFarther(middle + cv::Point2d(0.7 * tall, -0.5 * tall), near);
  }

 private:
  // In metres; 0: not measured, or beyond the picture.
  double At(const cv::Point2d& p) const {
    const int column = cvFloor(p.x), row = cvFloor(p.y);
    if (column < 0 || row < 0 || column >= depth_.width || row >= depth_.height) return 0;
    return depth_.at(column, row) / 1000.0;
  }

  // Of five places of the face the nearest that is measured, in metres; 0: none is.
  double Nearest(const cv::Point2d& middle, double apart) const {
    double nearest = 0;
    for (const auto& [right, down] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const double depth = At(middle + apart * cv::Point2d(right, down));
      if (depth > 0 && (nearest <= 0 || depth < nearest)) nearest = depth;
    }
    return nearest;
  }

  bool IsFarther(const cv::Point2d& p, double near) const {
    const double depth = At(p);
    return depth <= 0 || depth > near + kStep;
  }

  const DepthPicture& depth_;
  double focal_;
};

class MaskDetector : public Detector {
 public:
  explicit MaskDetector(MaskClassifier classifier)
      : classifier_(std::move(classifier)), histograms_(FaceHistograms()) {
    histograms_.setSVMDetector(classifier_.face);
  }

  std::vector<Sighting> Find(const DetectorInput& input) override {
    const cv::Mat gray = Gray(input.colour);
    std::vector<Sighting> faces;
    for (double zoom = 1;
         gray.cols >= zoom * kFaceWindow.width && gray.rows >= zoom * kFaceWindow.height;
         zoom *= kZoom) {
      FindOfSize(gray, zoom, input, faces);
    }
    faces = Suppress(std::move(faces), kSameOne);
    for (Sighting& face : faces) TellMask(View(input.colour), face);
    std::stable_sort(faces.begin(), faces.end(), [](const Sighting& a, const Sighting& b) {
      return a.confidence > b.confidence;
    });
    return faces;
  }

  bool Finds(SightingKind kind) const override {
    return kind == SightingKind::kFaceWithMask || kind == SightingKind::kFaceWithoutMask;
  }

 private:
  void FindOfSize(const cv::Mat& gray, double zoom, const DetectorInput& input,
                  std::vector<Sighting>& faces) const {
    const cv::Size size(cvFloor(gray.cols / zoom), cvFloor(gray.rows / zoom));
    const bool has_depth = HasDepth(input);
    cv::Rect area(0, 0, size.width + 2 * kRim, size.height + 2 * kRim);
    if (has_depth) area = HeadSizes(input).Area(area.size(), zoom);
    if (area.empty()) return;
    cv::Mat smaller;
    cv::resize(gray, smaller, size, 0, 0, cv::INTER_AREA);
    cv::copyMakeBorder(smaller, smaller, kRim, kRim, kRim, kRim, cv::BORDER_REPLICATE);
    std::vector<cv::Point> places = Look(smaller(area), {}, kPromising).places;
    for (cv::Point& place : places) place += area.tl();
    if (has_depth) {
      const auto is_of_no_use = [&](const cv::Point& p) { return !HeadSizes(input).Fits(p, zoom); };
      places.erase(std::remove_if(places.begin(), places.end(), is_of_no_use), places.end());
    }
    if (places.empty()) return;
    const Found found = Look(smaller, Around(places, smaller.size()), kLeastMargin);
    for (std::size_t i = 0; i < found.places.size(); ++i) {
      const cv::Point2d middle = MiddleOf(found.places[i], zoom);
      const Box box{middle.x - zoom * kFaceWide / 2, middle.y - zoom * kFaceTall / 2,
                    zoom * kFaceWide, zoom * kFaceTall};
      faces.push_back({SightingKind::kFace, box, Share(found.margins[i], 3)});
    }
  }

  struct Found {
    std::vector<cv::Point> places;
    std::vector<double> margins;
  };

  // At some places; if none are named, all over the picture.
  Found Look(const cv::Mat& picture, const std::vector<cv::Point>& places, double least) const {
    Found found;
    histograms_.detect(picture, found.places, found.margins, least, cv::Size(kStride, kStride),
                       cv::Size(), places);
    return found;
  }

  // Each place and the eight half a stride beside it.
  static std::vector<cv::Point> Around(const std::vector<cv::Point>& places, const cv::Size& size) {
    const cv::Rect possible(0, 0, size.width - kFaceWindow.width + 1,
                            size.height - kFaceWindow.height + 1);
    std::vector<cv::Point> around;
    for (const cv::Point& place : places) {
      for (int i = 0; i < 9; ++i) {
        const cv::Point beside =
            place + cv::Point((i % 3 - 1) * kStride / 2, (i / 3 - 1) * kStride / 2);
        if (beside.inside(possible)) around.push_back(beside);
      }
    }
    const auto is_before = [](const cv::Point& a, const cv::Point& b) {
      return a.y != b.y ? a.y < b.y : a.x < b.x;
    };
    std::sort(around.begin(), around.end(), is_before);
    around.erase(std::unique(around.begin(), around.end()), around.end());
    return around;
  }

  void TellMask(const cv::Mat& picture, Sighting& face) const {
    const double mask = Share(Margin(classifier_.mask, DescribeFace(picture, face.box)), 3);
    face.kind = mask > 0.5 ? SightingKind::kFaceWithMask : SightingKind::kFaceWithoutMask;
    face.confidence *= std::max(mask, 1 - mask);
  }

  MaskClassifier classifier_;
  cv::HOGDescriptor histograms_;
};

}  // namespace

std::unique_ptr<Detector> MakeMaskDetector(MaskClassifier classifier) {
  return std::make_unique<MaskDetector>(std::move(classifier));
}

}  // namespace coppice::robot::perception
