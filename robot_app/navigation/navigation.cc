#include "robot_app/navigation/navigation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot::navigation {
namespace {

constexpr double kPointRange = 3.0;    // obstacles farther away do not concern the follower [m]
constexpr double kProgress = 0.25;     // counts as having moved on [m]
constexpr double kLeftThePlace = 1.0;  // recoveries are available again after this [m]
constexpr double kLongestStep = 0.2;   // a longer pause between updates is not integrated [s]

}  // namespace

const char* ToString(NavigationStatus status) {
  switch (status) {
    case NavigationStatus::kIdle:
      return "idle";
    case NavigationStatus::kDriving:
      return "driving";
    case NavigationStatus::kBlocked:
      return "blocked";
    case NavigationStatus::kNoPath:
      return "no path";
  }
  return "";
}

Navigation::Navigation(NavigationSettings settings)
    : settings_(settings),
      static_costs_(settings.costs),
      costmap_(settings.costs),
      obstacles_(settings.obstacles),
      sonar_(settings.sonar),
      follower_(settings.follower) {}

void Navigation::SetMap(OccupancyGrid map) {
  map_ = std::move(map);
  static_costs_.Update(map_);
  costmap_ = static_costs_;
  obstacles_.Reset(map_.frame);
  sonar_.Reset(map_.frame);
  next_plan_ = 0;
}

void Navigation::SetGoal(const Pose2D& goal, double now) {
  goal_ = goal;
  end_ = End::kNone;
  StartOver(now);
  SetStatus(NavigationStatus::kDriving, now, "new goal");
}

void Navigation::Cancel(double now) {
  goal_.reset();
  follower_.ClearPath();
  ++path_number_;
  SetStatus(NavigationStatus::kIdle, now, "no goal");
}

void Navigation::Restart(double now) {
  follower_.Reset();
  StartOver(now);
}

// What was seen and begun is of another time: obstacles would stay, and plans wait, until it has
// come again.
void Navigation::TimeWasSetBack(double now) {
  obstacles_.Clear();
  sonar_.Reset(map_.frame);
  scan_.stamp = -HUGE_VAL;
  status_since_ = now;
  Restart(now);
}

void Navigation::StartOver(double now) {
  follower_.ClearPath();
  next_plan_ = now;
  held_since_ = -1;
  recovery_ = Recovery::kNone;
  turn_left_ = 0;
  progress_at_ = now;
  progress_pose_ = {HUGE_VAL, HUGE_VAL, 0};
  fresh_at_ = now;
}

void Navigation::AddScan(const Pose2D& pose, const LaserScan& scan) {
  scan_ = scan;
  scan_pose_ = pose;
  points_ = PointsInBase(scan, kPointRange);
  seen_.clear();
  for (const Point2D& point : points_) seen_.push_back(Compose(pose, point));
  if (has_map()) obstacles_.Insert(pose, scan);
}

Outcome Navigation::AddRange(const Pose2D& pose, const RangeReading& reading, double now) {
  if (!has_map()) return {};
  const bool is_seen_lately = std::abs(reading.stamp - scan_.stamp) <= settings_.sonar.oldest;
  return sonar_.Insert(pose, reading, is_seen_lately ? seen_ : std::vector<Point2D>(), now);
}

void Navigation::AddHeard(const Pose2D& pose, std::vector<Point2D>& points) const {
  sonar_.AddPoints(pose, kPointRange, points);
}

void Navigation::SetStatus(NavigationStatus status, double now, std::string message) {
  if (status != status_) status_since_ = now;
  status_ = status;
  message_ = std::move(message);
}

void Navigation::Finish(End end, double now, std::string message) {
  consecutive_failures_ = end == End::kReached ? 0 : consecutive_failures_ + 1;
  Cancel(now);
  end_ = end;
  message_ = std::move(message);
}

bool Navigation::SensorsFresh(double now, double pose_stamp) {
  const double pose_age = now - pose_stamp;
  const double scan_age = now - scan_.stamp;
  const double age = std::max(pose_age, scan_age);
  if (age <= settings_.sensor_timeout) {
    fresh_at_ = now;
    return true;
  }
  const char* const missing = pose_age >= scan_age ? "pose" : "laser scan";
  char text[80];
  if (std::isfinite(age)) {
    std::snprintf(text, sizeof text, "no %s for %.1f s", missing, age);
  } else {
    std::snprintf(text, sizeof text, "no %s yet", missing);
  }
  if (now - fresh_at_ > settings_.sensor_patience) {
    Finish(End::kAborted, now, text);
  } else {
    // Who has found no way, or has just failed, has none either while he sees nothing.
    const bool had_none = status_ == NavigationStatus::kNoPath || consecutive_failures_ > 0;
    const bool has_none = had_none && follower_.path().empty();
    SetStatus(has_none ? NavigationStatus::kNoPath : NavigationStatus::kBlocked, now, text);
    next_plan_ = 0;
  }
  return false;
}

Velocity2D Navigation::Update(double now, const Pose2D& pose, double pose_stamp) {
  if (now < last_update_) TimeWasSetBack(now);
  const double seconds = last_update_ < 0 ? 0 : std::clamp(now - last_update_, 0.0, kLongestStep);
  last_update_ = now;
  end_ = End::kNone;
  if (!goal_) return follower_.Brake(seconds);
  if (!has_map()) {
    Finish(End::kAborted, now, "there is no map yet");
    return follower_.Brake(seconds);
  }
  if (!SensorsFresh(now, pose_stamp)) {
    follower_.Reset();  // blind: not even a braking ramp
    return {};
  }
  sonar_.Forget(now);
  NoteProgress(now, pose);
  if (turn_left_ > 0) return TurnOnce(now, pose, seconds);
  if (now >= next_plan_ && !follower_.at_goal()) Replan(now, pose);
  const Velocity2D velocity = goal_ ? Drive(now, pose, seconds) : follower_.Brake(seconds);
  if (goal_ && OutOfPatience(now)) Recover(now, pose);
  return velocity;
}

void Navigation::EnterObstacles(double now) {
  obstacles_.Forget(now);
  std::vector<int> marked = obstacles_.marked();
  marked.insert(marked.end(), sonar_.marked().begin(), sonar_.marked().end());
  costmap_.Update(map_, marked);
}

Plan Navigation::FindWay(const Pose2D& pose, Point2D goal, double now) {
  if (!has_map()) return {PlanStatus::kNoPath, {}, 0, "there is no map yet"};
  EnterObstacles(now);
  return FindPath(costmap_, {pose.x, pose.y}, goal);
}

void Navigation::Replan(double now, const Pose2D& pose) {
  next_plan_ = now + settings_.replan_period;
  const Point2D goal{goal_->x, goal_->y};
  if (static_costs_.Lethal(map_.frame.CellAt(goal.x, goal.y))) {
    const Plan plan = FindPath(static_costs_, {pose.x, pose.y}, goal);
    Finish(End::kAborted, now, plan.message + " on the map");
    return;
  }
  EnterObstacles(now);
  const Plan plan = FindPath(costmap_, {pose.x, pose.y}, goal);
  ++path_number_;
  follower_.SetPath(SmoothPath(costmap_, plan.points), goal_->yaw);
  if (plan.status != PlanStatus::kOk) {
    SetStatus(NavigationStatus::kNoPath, now, plan.message);
  } else if (status_ == NavigationStatus::kNoPath) {
    SetStatus(NavigationStatus::kDriving, now, "found a path");
  }
}

Velocity2D Navigation::Drive(double now, const Pose2D& pose, double seconds) {
  if (follower_.path().empty()) return follower_.Brake(seconds);
  std::vector<Point2D> obstacles = points_;
  AddHeard(pose, obstacles);
  const Follower::Command command = follower_.Update(pose, obstacles, seconds);
  if (command.reached) {
    Finish(End::kReached, now, "goal reached");
    return command.velocity;
  }
  if (!command.obstacle) {
    held_since_ = -1;
    SetStatus(NavigationStatus::kDriving, now, "driving");
  } else if (held_since_ < 0) {
    held_since_ = now;
    next_plan_ = std::min(next_plan_, now + 0.3);  // look for a way around soon
  } else if (now - held_since_ > settings_.blocked_after) {
    SetStatus(NavigationStatus::kBlocked, now, "an obstacle is in the way");
  }
  return command.velocity;
}

void Navigation::NoteProgress(double now, const Pose2D& pose) {
  const double moved = Distance(pose, progress_pose_);
  // Turning at the goal is progress as well: it ends by itself.
  if (moved < kProgress && !follower_.at_goal()) return;
  // While a recovery is being tried, the place is what it was tried at.
  if (recovery_ != Recovery::kNone && moved < kLeftThePlace && !follower_.at_goal()) return;
  progress_pose_ = pose;
  progress_at_ = now;
  recovery_ = Recovery::kNone;
}

bool Navigation::OutOfPatience(double now) const {
  // Driving without getting anywhere is given more time: it may be a slow turn.
  const double factor = status_ == NavigationStatus::kDriving ? 2 : 1;
  return now - progress_at_ > factor * settings_.patience;
}

void Navigation::Recover(double now, const Pose2D& pose) {
  const double wait = settings_.patience - settings_.after_recovery;
  switch (recovery_) {
    case Recovery::kNone:
      recovery_ = Recovery::kForgetObstacles;
      obstacles_.Clear();
      obstacles_.Insert(scan_pose_, scan_);
      progress_at_ = now - wait;
      next_plan_ = now;
      return;
    case Recovery::kForgetObstacles:
      recovery_ = Recovery::kTurn;
      turn_left_ = 2 * M_PI;
      last_yaw_ = pose.yaw;
      return;
    case Recovery::kTurn:
      Finish(End::kAborted, now, message_ + ", and recovering did not help");
      return;
  }
}

Velocity2D Navigation::TurnOnce(double now, const Pose2D& pose, double seconds) {
  turn_left_ -= std::max(0.0, NormalizeAngle(pose.yaw - last_yaw_));
  last_yaw_ = pose.yaw;
  // A disc turns freely unless something already touches it, or its wheels do not move it.
  const bool touched = std::any_of(points_.begin(), points_.end(), [this](const Point2D& point) {
    return std::hypot(point.x, point.y) < settings_.follower.robot_radius;
  });
  const bool too_long = now - progress_at_ > 5 * settings_.patience;
  if (turn_left_ > 0.1 && !touched && !too_long) return follower_.Turn(turn_left_, seconds);
  turn_left_ = 0;
  progress_at_ = now - (settings_.patience - settings_.after_recovery);
  next_plan_ = now;
  return follower_.Brake(seconds);
}

}  // namespace coppice::robot::navigation
