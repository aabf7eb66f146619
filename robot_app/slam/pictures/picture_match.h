// Whether two pictures show the same things, and how the robot stood to where it stood then:
// geometric verification of a place that was found by its words.
//
// Corners that describe each other best are paired; the pose that most pairs agree with is found by
// RANSAC on the perspective of the new picture (PnP, OpenCV's calib3d). A pair agrees if its corner
// lies where it should in the picture *and* as far away as it should. A robot stays on its floor:
// a pose that rises or tilts is none. And the place that follows from the depths of the new picture
// alone, which PnP does not look at, must be the same.
#ifndef COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_MATCH_H_
#define COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_MATCH_H_

#include <optional>

#include "robot_app/slam/pictures/features.h"

namespace coppice::robot::slam {

struct MatchSettings {
  int least_inliers = 25;            ///< pairs that agree
  double least_share = 0.4;          ///< of the pairs
  double pixels = 3;                 ///< a pair may be off in the picture,
  double depth = 0.12;               ///< and in depth at 1 m; grows with the distance [m]
  double most_rise = 0.1;            ///< [m]
  double most_tilt = 0.05;           ///< [rad]
  double most_way = 3;               ///< between the two places [m]
  double least_spread = 0.25;        ///< of the pairs that agree: standard deviation in space [m]
  double most_contradiction = 0.12;  ///< between the places by perspective and by depth [m]
};

struct PictureMatch {
  int pairs = 0;
  int inliers = 0;
  double spread = 0;                   ///< of the pairs that agree, standard deviation in space [m]
  double contradiction = 0;            ///< between the places by perspective and by depth [m]
  Pose3 relative = Pose3::Identity();  ///< base_link of the new picture as seen from the old one's
};

/// Pairs of the two, with how many agree; not yet whether that is enough. Nothing: there are not
/// even so many pairs as must agree. 1 ms, and some more where there are.
std::optional<PictureMatch> MatchPictures(const PictureFeatures& old_picture,
                                          const PictureFeatures& new_picture,
                                          const CameraMount& new_camera,
                                          const MatchSettings& settings = {});

/// Whether it is enough to close a loop.
bool IsSure(const PictureMatch& match, const MatchSettings& settings = {});

/// Whether it is so much more than enough that no better one need be looked for.
bool IsClear(const PictureMatch& match, const MatchSettings& settings = {});

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_PICTURES_PICTURE_MATCH_H_
