#include "robot_app/perception/detection/face_window.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace coppice::robot::perception {
namespace {

constexpr int kMargin = 8;  // pixels around the window, for the gradients at its rim
const cv::Size kCells(10, 12);

// The window around a face and its margin, in the window's pixels.
cv::Mat CutOut(const cv::Mat& picture, const Box& box) {
  const double zoom = box.height / kFaceTall;
  const double wide = zoom * (kFaceWindow.width + 2 * kMargin);
  const double tall = zoom * (kFaceWindow.height + 2 * kMargin);
  const cv::Rect wanted(cvRound(box.x + box.width / 2 - wide / 2),
                        cvRound(box.y + box.height / 2 - tall / 2), std::max(1, cvRound(wide)),
                        std::max(1, cvRound(tall)));
  const cv::Rect there = wanted & cv::Rect({0, 0}, picture.size());
  cv::Mat part(wanted.size(), picture.type(), cv::Scalar::all(0));
  if (!there.empty()) {
    cv::copyMakeBorder(picture(there), part, there.y - wanted.y, wanted.br().y - there.br().y,
                       there.x - wanted.x, wanted.br().x - there.br().x, cv::BORDER_REPLICATE);
  }
  cv::resize(part, part, kFaceWindow + cv::Size(2 * kMargin, 2 * kMargin), 0, 0, cv::INTER_AREA);
  return part;
}

}  // namespace

cv::HOGDescriptor FaceHistograms() {
  return {kFaceWindow, cv::Size(16, 16), cv::Size(8, 8), cv::Size(8, 8), 9};
}

std::vector<float> DescribeFace(const cv::Mat& picture, const Box& box) {
  static const cv::HOGDescriptor kHistograms = FaceHistograms();
  const cv::Mat part = CutOut(picture, box);
  cv::Mat gray, cells;
  cv::cvtColor(part, gray, cv::COLOR_RGB2GRAY);
  std::vector<float> features;
  kHistograms.compute(gray, features, cv::Size(8, 8), cv::Size(), {cv::Point(kMargin, kMargin)});
  cv::resize(part(cv::Rect({kMargin, kMargin}, kFaceWindow)), cells, kCells, 0, 0, cv::INTER_AREA);
  cv::cvtColor(cells, cells, cv::COLOR_RGB2YCrCb);
  std::transform(cells.datastart, cells.dataend, std::back_inserter(features),
                 [](std::uint8_t value) { return static_cast<float>(value) / 255; });
  return features;
}

}  // namespace coppice::robot::perception
