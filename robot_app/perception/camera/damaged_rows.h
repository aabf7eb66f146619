// Damage of pictures on their way from the camera: rows that are shifted, of wrong colours or gone,
// as a bad cable makes them, more and more of them the longer it works (ECMR 2021, section V). The
// picture can still be decoded, so nobody else notices.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CAMERA_DAMAGED_ROWS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CAMERA_DAMAGED_ROWS_H_

#include "robot_app/common/picture.h"

namespace coppice::robot::perception {

/// The share of the rows that do not fit the next one, 0 to 1: they differ all along, far more than
/// rows of this picture do otherwise, and only one of the two has depth. The joints of a tiled
/// floor differ as much, but all of it has depth. A damaged strip makes two. Without depth of the
/// same size, and where nothing has depth, nothing is known: 0.
double TornShare(const Picture& picture, const DepthPicture& depth);

/// The mean of the last pictures, so that one unusual view says nothing.
class TornGauge {
 public:
  void Add(const Picture& picture, const DepthPicture& depth);
  /// 0 to 1.
  double share() const { return share_; }
  /// More than undamaged cameras ever show.
  bool is_damaged() const;

 private:
  double share_ = 0;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CAMERA_DAMAGED_ROWS_H_
