// Who is in the pictures of an RGB-D camera, and where: by detectors in colour, and in depth as in
// the clouds of a lidar.
//
//   PeopleInPictures people(*detector, std::move(*PersonClassifier::Load(file)));
//   for (const PlacedSighting& placed : people.Find(colour, ranges)) ...
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CAMERA_PEOPLE_IN_PICTURES_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CAMERA_PEOPLE_IN_PICTURES_H_

#include <optional>
#include <vector>

#include "robot_app/perception/clouds/people_finder.h"
#include "robot_app/perception/detection/detector.h"
#include "robot_app/perception/sightings/joined_sightings.h"

namespace coppice::robot::perception {

/// One camera, by one thread at a time.
class PeopleInPictures {
 public:
  /// Without a classifier depth is only used to say where somebody is. The detector may serve
  /// several cameras; it must live as long.
  PeopleInPictures(Detector& detector, std::optional<PersonClassifier> classifier)
      : detector_(detector), classifier_(std::move(classifier)) {}

  /// Surest first. The camera looks level; its height must stay as it is.
  std::vector<PlacedSighting> Find(const Picture& colour, const Ranges& ranges);

  /// In depth alone: a tenth of the time, and no face is seen. Nobody without a classifier.
  std::vector<PlacedSighting> FindInDepth(const Ranges& ranges);

 private:
  Detector& detector_;
  std::optional<PersonClassifier> classifier_;  // until the finder has it
  std::optional<PeopleFinder> finder_;          // once the height of the camera is known
  std::vector<LidarPoint> points_;
};

/// Whether a moment shows so little that something must hang before the lens: one shade, and
/// nothing at a distance. Without depth (no pixels) the shade decides.
bool IsCovered(const Picture& picture, const DepthPicture& depth);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CAMERA_PEOPLE_IN_PICTURES_H_
