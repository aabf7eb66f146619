// Pictures of the simulated RGB-D camera with the truth about the faces in them.
#ifndef COPPICE_ROBOT_APP_TRAINING_LABELLED_PICTURE_H_
#define COPPICE_ROBOT_APP_TRAINING_LABELLED_PICTURE_H_

#include <random>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::training {

struct LabelledPicture {
  Picture colour;
  DepthPicture depth;
  double focal = 0;  ///< of the lens [pixels]
  /// From the hairline to the chin. Of confidence 0 is who is hidden, cut off by the picture's rim,
  /// turned more than 60 degrees away or farther than 4 m: to see him or not counts neither way.
  std::vector<perception::Sighting> faces;
};

/// A random hall with one to three people 0.8 to 4 m before the lens, turned up to 60 degrees
/// aside, half of them with a mask and some with one at the chin, and others who stand anywhere and
/// look anywhere; in bright, dim, warm or cold light, sharp or a little blurred. The same state of
/// `random` gives the same picture.
LabelledPicture MakeLabelledPicture(std::mt19937_64& random);

}  // namespace coppice::robot::training

#endif  // COPPICE_ROBOT_APP_TRAINING_LABELLED_PICTURE_H_
