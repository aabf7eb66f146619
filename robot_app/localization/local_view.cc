#include "robot_app/localization/local_view.h"

#include <cmath>

namespace coppice::robot::localization {
namespace {

constexpr double kTurn = 0.6;          // between two looks [rad]
constexpr double kWay = 0.6;           // m
constexpr std::size_t kMostLooks = 8;  // older ones are forgotten: odometry drifts, people walk
constexpr double kCompleteTurn = 2.4;  // with a scanner that sees at least 270 degrees [rad]
constexpr double kCompleteWay = 3;     // m

}  // namespace

void LocalView::Clear() {
  looks_.clear();
  turned_ = 0;
  moved_ = 0;
}

bool LocalView::Add(const Pose2D& odometry, const std::vector<Beam>& beams) {
  if (!looks_.empty()) {
    const Pose2D since = RelativeTo(looks_.back().odometry, odometry);
    const double way = std::hypot(since.x, since.y);
    if (std::abs(since.yaw) < kTurn && way < kWay) return false;
    turned_ += std::abs(since.yaw);
    moved_ += way;
  }
  looks_.push_back({odometry, beams});
  if (looks_.size() > kMostLooks) looks_.pop_front();
  return true;
}

bool LocalView::complete() const { return turned_ >= kCompleteTurn || moved_ >= kCompleteWay; }

std::vector<Beam> LocalView::From(const Pose2D& odometry) const {
  std::vector<Beam> all;
  for (const Look& look : looks_) {
    const std::vector<Beam> moved = Moved(look.beams, RelativeTo(odometry, look.odometry));
    all.insert(all.end(), moved.begin(), moved.end());
  }
  return all;
}

}  // namespace coppice::robot::localization
