#include "robot_app/perception/detection/detector.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "robot_app/perception/detection/face_detector.h"
#include "robot_app/perception/detection/network_detector.h"
#include "robot_app/perception/detection/people_detector.h"

namespace coppice::robot::perception {
namespace {

using Detectors = std::vector<std::unique_ptr<Detector>>;

// What all of several see.
class Together : public Detector {
 public:
  Together(Detectors detectors, double least) : detectors_(std::move(detectors)), least_(least) {}

  std::vector<Sighting> Find(const DetectorInput& input) override {
    std::vector<Sighting> all;
    for (const auto& detector : detectors_) {
      for (const Sighting& sighting : detector->Find(input)) {
        if (sighting.confidence >= least_) all.push_back(sighting);
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Sighting& a, const Sighting& b) {
      return a.confidence > b.confidence;
    });
    return all;
  }

 private:
  Detectors detectors_;
  double least_;
};

Expected<std::unique_ptr<Detector>> MakeBuiltIn(const std::string& name,
                                                const DetectorChoice& choice) {
  if (name == "people") return MakePeopleDetector();
  if (name == "faces") {
    return MakeFaceDetector(choice.cascade_file.empty() ? kFaceCascade : choice.cascade_file);
  }
  return Problem{"there is no detector \"" + name + "\"" + DidYouMean(name, {"people", "faces"}) +
                 "; expected people, faces or both"};
}

}  // namespace

Expected<std::unique_ptr<Detector>> MakeDetector(const DetectorChoice& choice) {
  if (!choice.network.file.empty()) {
    return MakeNetworkDetector(choice.network, choice.least_confidence);
  }
  Detectors detectors;
  std::istringstream names(choice.built_in);
  for (std::string name; names >> name;) {
    auto detector = MakeBuiltIn(name, choice);
    if (!detector) return Problem{detector.problem()};
    detectors.push_back(std::move(*detector));
  }
  if (detectors.empty()) return Problem{"expected one of the detectors people and faces"};
  return std::unique_ptr<Detector>(
      std::make_unique<Together>(std::move(detectors), choice.least_confidence));
}

}  // namespace coppice::robot::perception
