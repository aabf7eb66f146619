#include "robot_app/perception/people/people_follower.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "robot_app/common/ros_support.h"
#include "robot_app/perception/clouds/hidden.h"
#include "robot_app/perception/people/cloud_decoder.h"
#include "robot_app/perception/people/sighting_messages.h"
#include "robot_app/perception/sightings/joined_sightings.h"
#include "robot_app/perception/sightings/leg_detections.h"

namespace coppice::robot::perception {
namespace {

constexpr double kPeriod = 0.1;      // of a turn of the lidar [s]
constexpr double kLowest = 0.2;      // the lidar is at least so high above the floor [m]
constexpr double kHighest = 3;       // and at most [m]
constexpr double kLidarAlive = 0.5;  // no cloud for longer: it sees nobody [s]
constexpr double kCameraAlive = 1.5;
constexpr double kLaserAlive = 0.5;
constexpr double kTooFar = 0.5;  // nearer than the end of a camera's view is surely in it [m]
constexpr std::size_t kMostCameras = 16;

Detection ToDetection(const SeenPerson& person, const Pose2D& lidar) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(lidar.yaw).toRotationMatrix();
  Detection detection;
  detection.position = turn * person.position.cast<double>() + Eigen::Vector2d(lidar.x, lidar.y);
  detection.covariance = turn * person.covariance.cast<double>() * turn.transpose();
  detection.probability = person.probability;
  return detection;
}

// From a pose, in its axes.
Eigen::Vector2d SeenFrom(const Pose2D& pose, const Eigen::Vector2d& at) {
  return Eigen::Rotation2Dd(-pose.yaw) * (at - Eigen::Vector2d(pose.x, pose.y));
}

}  // namespace

PeopleFollower::PeopleFollower(const FollowerOptions& options, Classifiers classifiers,
                               FindTransform find_transform)
    : options_(options),
      classifier_(std::move(classifiers.clouds)),
      find_transform_(std::move(find_transform)),
      leg_finder_({}, std::move(classifiers.legs)) {}

Expected<Classifiers> Classifiers::Load(const std::string& clouds_file,
                                        const std::string& legs_file) {
  auto clouds = PersonClassifier::Load(clouds_file);
  if (!clouds) return Problem{clouds.problem()};
  auto legs = LegClassifier::Load(legs_file);
  if (!legs) return Problem{legs.problem()};
  return Classifiers{std::move(*clouds), std::move(*legs)};
}

Outcome PeopleFollower::OnCloud(const sensor_msgs::PointCloud2& message) {
  if (Outcome decoded = Decode(message, points_); !decoded) return decoded;
  const auto mount = MountAt(message.header.frame_id, message.header.stamp);
  if (!mount) return Problem{mount.problem()};
  PeopleFinder& finder = FinderAt(mount->height);
  std::vector<Detection> detections;
  for (const SeenPerson& person : finder.Find(points_)) {
    // The robot may have turned since the turn of the lidar began.
    const ros::Time met = message.header.stamp + ros::Duration(person.turn * kPeriod);
    const auto then = MountAt(message.header.frame_id, met);
    detections.push_back(ToDetection(person, then ? then->pose : mount->pose));
  }
  lidar_ = mount->pose;
  cloud_time_ = (message.header.stamp + ros::Duration(kPeriod / 2)).toSec();
  Update(cloud_time_, detections);
  return {};
}

Expected<double> PeopleFollower::OnSightings(const coppice_msgs::Sightings& message) {
  if (message.header.frame_id != options_.frame) {
    return Problem{"sightings are in the frame " + message.header.frame_id + ", expected " +
                   options_.frame};
  }
  auto sightings = FromMessage(message);
  if (!sightings) return Problem{sightings.problem()};
  if (views_.size() >= kMostCameras && views_.count(message.camera) == 0) {
    return Problem{"there are more than " + std::to_string(kMostCameras) + " cameras"};
  }
  const double time = message.header.stamp.toSec();
  views_[message.camera] = {time,
                            {message.lens.x, message.lens.y, message.lens.theta},
                            message.half_angle,
                            message.farthest};
  const double late = std::max(tracker_.time() - time, 0.0);
  Update(time, Join(*std::move(sightings)));
  return late;
}

Expected<bool> PeopleFollower::OnScan(const sensor_msgs::LaserScan& message) {
  const double time = message.header.stamp.toSec();
  if (first_scan_ < 0) first_scan_ = time;
  if (IsLidarAlive(time)) return false;
  if (message.ranges.size() > kMostBeams) {
    return Problem{"a scan has " + std::to_string(message.ranges.size()) + " beams, at most " +
                   std::to_string(kMostBeams) + " are looked at"};
  }
  LaserScan scan = ToLaserScan(message, {});
  if (!IsUsable(scan)) return Problem{"a scan is not usable: " + WhatTells(scan)};
  const auto mount = MountAt(message.header.frame_id, message.header.stamp);
  if (!mount) return Problem{mount.problem()};
  scan_ = std::move(scan);
  laser_ = mount->pose;
  std::vector<Detection> detections;
  for (const SeenLegs& person : leg_finder_.Find(scan_)) {
    // As in a turn of the lidar.
    const ros::Duration later(std::clamp<double>(person.beam * message.time_increment, 0, 1));
    const auto then = MountAt(message.header.frame_id, message.header.stamp + later);
    detections.push_back(ToDetection(person, then ? then->pose : laser_));
  }
  Update(time, detections);
  return true;
}

void PeopleFollower::Update(double time, const std::vector<Detection>& detections) {
  tracker_.Update(time, detections, [this](const Eigen::Vector2d& at) { return IsOutOfSight(at); });
}

bool PeopleFollower::IsLidarAlive(double time) const {
  return std::abs(time - cloud_time_) < kLidarAlive || std::abs(time - first_scan_) < kLidarAlive;
}

bool PeopleFollower::IsInPicture(const Eigen::Vector2d& at) const {
  return std::any_of(views_.begin(), views_.end(), [&](const auto& camera) {
    const View& view = camera.second;
    const Eigen::Vector2d seen = SeenFrom(view.lens, at);
    return std::abs(tracker_.time() - view.time) < kCameraAlive &&
           seen.norm() < view.farthest - kTooFar &&
           std::abs(std::atan2(seen.y(), seen.x())) < view.half_angle;
  });
}

bool PeopleFollower::IsInScan(const Eigen::Vector2d& at) const {
  return std::abs(tracker_.time() - scan_.stamp) < kLaserAlive &&
         !IsHidden(scan_, leg_finder_.options().farthest, SeenFrom(laser_, at));
}

// No sensor that is alive sees that place.
bool PeopleFollower::IsOutOfSight(const Eigen::Vector2d& at) const {
  if (finder_ && std::abs(tracker_.time() - cloud_time_) < kLidarAlive) {
    return IsHidden(finder_->candidates().image(), SeenFrom(lidar_, at).cast<float>());
  }
  return !IsInPicture(at) && !IsInScan(at);
}

// At that time, or the newest that is known.
Expected<PeopleFollower::Mount> PeopleFollower::MountAt(const std::string& lidar,
                                                        const ros::Time& time) const {
  auto found = find_transform_(options_.frame, lidar, time);
  if (!found) found = find_transform_(options_.frame, lidar, ros::Time(0));
  if (!found) return Problem{found.problem()};
  const geometry_msgs::Transform& transform = found->transform;
  const double height = transform.translation.z;
  if (!(height >= kLowest && height <= kHighest)) {
    return Problem{"the lidar " + lidar + " is " + std::to_string(height) + " m above " +
                   options_.frame + ", expected 0.2 to 3"};
  }
  return Mount{{transform.translation.x, transform.translation.y, YawOf(transform.rotation)},
               height};
}

PeopleFinder& PeopleFollower::FinderAt(double height) {
  if (finder_) return *finder_;
  FinderOptions options;
  options.candidates.geometry.height = static_cast<float>(height);
  options.least_probability = static_cast<float>(options_.least_probability);
  options.farthest = static_cast<float>(options_.farthest);
  return finder_.emplace(options, std::move(classifier_));
}

}  // namespace coppice::robot::perception
