// Finds people and faces in pictures: one interface, several ways behind it.
//
//   Expected<std::unique_ptr<Detector>> detector = MakeDetector({});
//   for (const Sighting& sighting : (*detector)->Find(picture)) ...
//   for (const Sighting& sighting : (*detector)->Find({picture, &depth, lens.fx})) ...
//
//   people    OpenCV's histograms of gradients with its own weights (Dalal and Triggs 2005): whole
//             people from about 3 m, whose feet are seen
//   faces     OpenCV's cascade for faces from the front (Viola and Jones 2001, Lienhart 2002)
//   masks     faces turned up to 60 degrees aside, told apart by with and without mask, by a
//             classifier that `coppice-train masks` made
//   network   a network that the user has: Darknet (YOLOv3) or ONNX (heads of YOLOv5 and YOLOv8)
//
// Pictures in, boxes out: no ROS, no files but those that are named here. A detector is used by one
// thread at a time.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_DETECTOR_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_DETECTOR_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

/// What a detector looks at: a picture, and if there is one the depth of each of its pixels, which
/// says how large a head must be there. A depth picture of another size is not used. Both live as
/// long as it is looked at.
struct DetectorInput {
  DetectorInput(const Picture& picture)  // NOLINT(google-explicit-constructor): a picture is enough
      : colour(picture) {}
  DetectorInput(const Picture& picture, const DepthPicture* depths, double focal_length)
      : colour(picture), depth(depths), focal(focal_length) {}

  const Picture& colour;
  const DepthPicture* depth = nullptr;
  double focal = 0;  ///< of the lens [pixels]
};

class Detector {
 public:
  virtual ~Detector() = default;

  /// Surest first. Of a picture of any size; in one that is too small nothing is seen.
  virtual std::vector<Sighting> Find(const DetectorInput& input) = 0;

  /// Whether it ever sees something of this kind.
  virtual bool Finds(SightingKind kind) const = 0;
};

/// A network of the user's. `file` decides about its kind: .weights (with `config`) or .onnx.
struct NetworkFiles {
  std::string file;     ///< empty: no network
  std::string config;   ///< Darknet's .cfg
  std::string classes;  ///< a name a line; empty: the 80 of COCO, or people if there is one only
  int size = 0;         ///< of the square picture that it takes [pixels]; 0: as it says itself,
                        ///< else 640
};

struct DetectorChoice {
  /// Some of people, faces and masks. Beside a network only those work that find what it does not:
  /// masks, if it knows people alone.
  std::string built_in = "people faces";
  std::string cascade_file;  ///< for faces; empty: that of Debian's opencv-data
  std::string mask_file;     ///< for masks: what `coppice-train masks` wrote
  NetworkFiles network;
  double least_confidence = 0.5;
};

/// Reads everything that is needed and tries it on an empty picture: what is missing or does not
/// fit is a problem here and now.
Expected<std::unique_ptr<Detector>> MakeDetector(const DetectorChoice& choice);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_DETECTOR_H_
