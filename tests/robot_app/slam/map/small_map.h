#ifndef COPPICE_TESTS_ROBOT_APP_SLAM_MAP_SMALL_MAP_H_
#define COPPICE_TESTS_ROBOT_APP_SLAM_MAP_SMALL_MAP_H_

#include <limits>
#include <memory>

#include "robot_app/slam/map/slam_map.h"

namespace coppice::robot::slam {

// Two sessions of two key frames, joined by a closure.
inline SlamMap SmallMap() {
  SlamMap map;
  map.names = {{"monday", 10}, {"tuesday", 100}};
  map.sessions = {0, 0, 1, 1};
  for (int i = 0; i < 4; ++i) {
    Pose3 pose = Pose3::Identity();
    pose.translation() << 0.5 * i, 1, 0;
    pose.linear() = Eigen::AngleAxisd(0.3 * i, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    map.graph.poses.push_back(pose);
    auto key_frame = std::make_shared<KeyFrame>();
    key_frame->stamp = 10 * i;
    if (i == 2) key_frame->place = Pose2D{4, -1.5, 0.25};
    key_frame->points = {{1, 2, 0.5F}, {-3.25F, 0, 1}};
    key_frame->camera_clouds = {{{0.25F, 0, 1.5F}, {{2, 1, 0.75F}, {2, -1, 0.5F}}}};
    key_frame->descriptor.contour[7] = 4.5F;
    PictureFeatures picture;
    picture.pixels = {{100.5F, 20}};
    picture.descriptors = {{1, 2, 3, static_cast<std::uint64_t>(i)}};
    picture.points = {Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN())};
    key_frame->pictures = {std::make_shared<PictureFeatures>(picture)};
    map.key_frames.push_back(key_frame);
  }
  map.graph.links = {{0, 1, Pose3::Identity(), InformationOf(0.1, 0.01), LinkKind::kStep},
                     {0, 3, map.graph.poses[3], InformationOf(0.1, 0.01), LinkKind::kCloud}};
  return map;
}

}  // namespace coppice::robot::slam

#endif  // COPPICE_TESTS_ROBOT_APP_SLAM_MAP_SMALL_MAP_H_
