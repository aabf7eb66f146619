#include "robot_app/perception/detection/face_detector.h"

#include <algorithm>
#include <opencv2/objdetect.hpp>
#include <random>
#include <utility>

#include "bt_core/base/read_file.h"
#include "robot_app/perception/detection/picture_view.h"
#include "robot_app/perception/detection/suppression.h"
#include "robot_app/perception/detection/try_apart.h"

namespace coppice::robot::perception {
namespace {

constexpr double kZoom = 1.1;
constexpr int kNeighbours = 3;  // windows that agree
constexpr int kSmallest = 24;   // pixels
constexpr double kSure = 12;    // neighbours of a face that is surely one
constexpr double kSameOne = 0.4;

class FaceDetector : public Detector {
 public:
  explicit FaceDetector(cv::CascadeClassifier cascade) : cascade_(std::move(cascade)) {}

  std::vector<Sighting> Find(const DetectorInput& input) override {
    const cv::Mat gray = Gray(input.colour);
    if (gray.empty()) return {};
    std::vector<cv::Rect> boxes;
    std::vector<int> neighbours;
    cascade_.detectMultiScale(gray, boxes, neighbours, kZoom, kNeighbours, 0,
                              cv::Size(kSmallest, kSmallest));
    std::vector<Sighting> sightings;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const double confidence = std::min(0.5 + 0.5 * (neighbours[i] - kNeighbours) / kSure, 1.0);
      sightings.push_back({SightingKind::kFace, ToBox(boxes[i]), confidence});
    }
    return Suppress(std::move(sightings), kSameOne);
  }

  bool Finds(SightingKind kind) const override { return kind == SightingKind::kFace; }

 private:
  cv::CascadeClassifier cascade_;
};

// Read from memory: OpenCV prints about a file that it cannot open and parse.
bool Read(const std::string& text, cv::CascadeClassifier& cascade) {
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    return storage.isOpened() && cascade.read(storage.getFirstTopLevelNode());
  } catch (const std::exception&) {  // not only cv::Exception
    return false;
  }
}

// In noise there is something of everything that a cascade may ask for.
Picture Noise() {
  Picture picture(160, 120);
  std::minstd_rand random(1);
  for (std::uint8_t& shade : picture.rgb) shade = static_cast<std::uint8_t>(random() >> 8);
  return picture;
}

Expected<std::unique_ptr<Detector>> MakeHere(const std::string& file, const std::string& text) {
  cv::CascadeClassifier cascade;
  if (!Read(text, cascade)) return Problem{file + ": expected a cascade of OpenCV (XML)"};
  return std::unique_ptr<Detector>(std::make_unique<FaceDetector>(std::move(cascade)));
}

// What it throws would end the program later, too.
int Try(const std::string& file, const std::string& text) {
  const auto detector = MakeHere(file, text);
  const Picture noise = Noise();
  if (detector) (*detector)->Find(noise);
  return 0;
}

}  // namespace

Expected<std::unique_ptr<Detector>> MakeFaceDetector(const std::string& file) {
  const auto text = ReadFile(file);
  if (!text) {
    return Problem{file + ": cannot be read; Debian's package opencv-data has face cascades"};
  }
  const Expected<int> tried = TryApart([&] { return Try(file, *text); });
  if (!tried) return Problem{file + ": OpenCV " + tried.problem() + " with this cascade"};
  return MakeHere(file, *text);
}

}  // namespace coppice::robot::perception
