#include "robot_app/perception/sightings/leg_detections.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace coppice::robot::perception {
namespace {

constexpr double kSurest = 0.8;  // of one scan

}  // namespace

Detection ToDetection(const SeenLegs& person, const Pose2D& laser) {
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(laser.yaw).toRotationMatrix();
  Detection detection;
  detection.position = turn * person.position.cast<double>() + Eigen::Vector2d(laser.x, laser.y);
  detection.covariance = turn * person.covariance.cast<double>() * turn.transpose();
  detection.probability = std::min<double>(person.probability, kSurest);
  detection.modality = Modality::kLaser;
  return detection;
}

}  // namespace coppice::robot::perception
