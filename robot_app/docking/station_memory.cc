#include "robot_app/docking/station_memory.h"

#include <cmath>
#include <utility>

#include "robot_app/common/places/pose_file.h"

namespace coppice::robot::docking {
namespace {

constexpr double kFarthest = 1.5;  // from the prior [m]
constexpr double kMoved = 0.01;    // m and rad

bool IsSame(const Pose2D& a, const Pose2D& b) {
  return Distance(a, b) < kMoved && std::abs(NormalizeAngle(a.yaw - b.yaw)) < kMoved;
}

}  // namespace

StationMemory::StationMemory(const std::optional<Pose2D>& prior, std::string file)
    : station_(prior), file_(std::move(file)) {
  if (file_ == "none") return;
  kept_ = LoadPose(file_);
  if (kept_ && prior && Distance(*kept_, *prior) <= kFarthest) station_ = kept_;
}

bool StationMemory::Learn(const Pose2D& station) {
  station_ = station;
  return file_ != "none" && !(kept_ && IsSame(*kept_, station));
}

Outcome StationMemory::Save(const Pose2D& station) const { return SavePose(file_, station); }

}  // namespace coppice::robot::docking
