#include "robot_app/perception/detection/detector.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "robot_app/perception/detection/face_detector.h"
#include "robot_app/perception/detection/mask_detector.h"
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

  bool Finds(SightingKind kind) const override {
    return std::any_of(detectors_.begin(), detectors_.end(),
                       [kind](const auto& detector) { return detector->Finds(kind); });
  }

 private:
  Detectors detectors_;
  double least_;
};

enum class BuiltIn { kPeople, kFaces, kMasks };

constexpr std::array<const char*, 3> kNames = {"people", "faces", "masks"};

Expected<std::vector<BuiltIn>> ParseNames(const std::string& text) {
  std::vector<BuiltIn> chosen;
  std::istringstream names(text);
  for (std::string name; names >> name;) {
    const auto* const found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) {
      return Problem{"there is no detector \"" + name + "\"" +
                     DidYouMean(name, {kNames.begin(), kNames.end()}) +
                     "; expected some of people, faces and masks"};
    }
    chosen.push_back(static_cast<BuiltIn>(found - kNames.begin()));
  }
  return chosen;
}

// A network sees people and faces better; whether a face has a mask only some networks know.
bool IsKnownTo(const Detector& network, BuiltIn built_in) {
  const bool tells_masks =
      network.Finds(SightingKind::kFaceWithMask) || network.Finds(SightingKind::kFaceWithoutMask);
  switch (built_in) {
    case BuiltIn::kPeople:
      return network.Finds(SightingKind::kPerson);
    case BuiltIn::kFaces:
      return tells_masks || network.Finds(SightingKind::kFace);
    case BuiltIn::kMasks:
      return tells_masks;
  }
  return false;
}

Expected<std::unique_ptr<Detector>> MakeMasks(const std::string& file) {
  if (file.empty()) return Problem{"masks need a file that `coppice-train masks` wrote"};
  auto classifier = LoadMaskClassifier(file);
  if (!classifier) return Problem{classifier.problem()};
  return MakeMaskDetector(std::move(*classifier));
}

Expected<std::unique_ptr<Detector>> MakeBuiltIn(BuiltIn built_in, const DetectorChoice& choice) {
  switch (built_in) {
    case BuiltIn::kPeople:
      return MakePeopleDetector();
    case BuiltIn::kFaces:
      return MakeFaceDetector(choice.cascade_file.empty() ? kFaceCascade : choice.cascade_file);
    case BuiltIn::kMasks:
      return MakeMasks(choice.mask_file);
  }
  return Problem{"there is no such detector"};
}

}  // namespace

Expected<std::unique_ptr<Detector>> MakeDetector(const DetectorChoice& choice) {
  const auto names = ParseNames(choice.built_in);
  if (!names) return Problem{names.problem()};
  Detectors detectors;
  if (!choice.network.file.empty()) {
    auto network = MakeNetworkDetector(choice.network, choice.least_confidence);
    if (!network) return Problem{network.problem()};
    detectors.push_back(std::move(*network));
  }
  const Detector* const network = detectors.empty() ? nullptr : detectors.front().get();
  for (const BuiltIn name : *names) {
    if (network != nullptr && IsKnownTo(*network, name)) continue;
    auto detector = MakeBuiltIn(name, choice);
    if (!detector) return Problem{detector.problem()};
    detectors.push_back(std::move(*detector));
  }
  if (detectors.empty()) return Problem{"expected one of the detectors people, faces and masks"};
  return std::unique_ptr<Detector>(
      std::make_unique<Together>(std::move(detectors), choice.least_confidence));
}

}  // namespace coppice::robot::perception
