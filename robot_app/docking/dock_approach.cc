// DockController: the way into the station.
#include <algorithm>
#include <cmath>

#include "robot_app/docking/dock_controller.h"
#include "robot_app/docking/dock_text.h"

namespace coppice::robot::docking {
namespace {

using Phase = DockController::Phase;

constexpr double kAtStaging = 0.06;      // near enough to the staging pose [m]
constexpr double kAligned = 0.03;        // rad
constexpr double kInSight = 1.0;         // a landmark farther aside is turned to [rad]
constexpr double kFacing = 0.6;          // it faces the station [rad]
constexpr double kFirstLook = 4.0;       // s, before it goes to the staging pose to see more
constexpr double kFarFromStaging = 0.4;  // m
constexpr double kFullTurn = 14;         // s, for a look around
constexpr double kPlanAgain = 0.5;       // s, while no way is free
constexpr double kWaitForWay = 2.5;      // s, before it goes to the staging pose
constexpr double kLeftPath = 0.12;       // so far beside its path it plans anew [m]
constexpr double kSlowFrom = 1.0;        // before the contacts, on its way [m]
constexpr double kSlowBeside = 0.45;     // the same along the axis, wherever it is [m]
constexpr double kGoRoundAfter = 1.5;    // standing before an obstacle [s]
constexpr int kMostWaysRound = 4;
constexpr double kMakesWayAfter = 3;    // of waiting for who stands before the station [s]
constexpr double kBefore = 0.1;         // the station, and so far before it ...
constexpr double kBeforeUpTo = 1.6;     // ... up to there ...
constexpr double kBeforeAside = 0.5;    // ... and so far aside [m]
constexpr double kStagingHeld = 4;      // held on the way to the staging pose, it looks again [s]
constexpr double kHasDrivenOn = 0.1;    // after standing before an obstacle [m]
constexpr double kHides = 0.15;         // so near to the direction to the landmark [rad]
constexpr double kFarBefore = 0.6;      // nearer than it by so much [m]
constexpr double kAtContact = 0.008;    // before the docked pose [m]
constexpr double kNearContact = 0.08;   // standing still here means contact [m]
constexpr double kNoticeAhead = 0.45;   // what is in the way so far ahead holds the robot [m]
constexpr double kBlind = 1.5;          // drives so long without seeing the landmark [s]
constexpr double kNoMoreNeeded = 0.15;  // so near it need not be seen any more [m]
constexpr double kCheckAt = 0.12;       // here it must be straight before the contacts [m]
constexpr double kMostAside = 0.022;    // m
constexpr double kMostTurned = 0.045;   // rad

// Does something stand before the landmark, which should be there in base_link?
bool IsHidden(const std::vector<Point2D>& obstacles, const Pose2D& landmark) {
  const double direction = std::atan2(landmark.y, landmark.x);
  const double away = std::hypot(landmark.x, landmark.y);
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const Point2D& point) {
    return std::abs(NormalizeAngle(std::atan2(point.y, point.x) - direction)) < kHides &&
           std::hypot(point.x, point.y) < away - kFarBefore;
  });
}

}  // namespace

Velocity2D DockController::Look(const DockInput& input, double seconds) {
  if (input.seen && input.now - input.seen->stamp < kBlind) {
    if (input.now - last_plan_ < kPlanAgain) return Stand();
    last_plan_ = input.now;
    return Plan(input);
  }
  const double looked = input.now - entered_;
  if (CanStage(input) && looked > kFirstLook) return DriveOut(input, settings_.staging_distance);
  if (IsToMakeWay(input, looked)) return MakeWay(input);
  if (looked > (station_ ? settings_.look_for : kFullTurn)) {
    const bool hidden = station_ && IsHidden(input.obstacles, RelativeTo(input.pose, Landmark()));
    return AttemptFailed(input, std::string("the landmark of the station is not seen") +
                                    (hidden ? ": an obstacle stands before it" : ""));
  }
  return TurnTowards(input, seconds);
}

// Before the station everything can be seen; from its side not.
bool DockController::CanStage(const DockInput& input) const {
  return station_ && !has_staged_ && Distance(input.pose, *staging()) > kFarFromStaging;
}

Velocity2D DockController::DriveOut(const DockInput& input, double distance) {
  has_staged_ = true;
  stage_at_ = distance;
  Enter(Phase::kTurnToStaging, input);
  return velocity_;
}

// Does somebody stand between the robot and the station, perhaps because he cannot get past it?
bool DockController::IsToMakeWay(const DockInput& input, double waited) const {
  if (!station_ || has_made_way_ || waited < kMakesWayAfter) return false;
  const Pose2D in_station = InStation(input);
  const auto obstacles = WithoutStation(input.obstacles, in_station, settings_.landmark);
  return std::any_of(obstacles.begin(), obstacles.end(), [&](const Point2D& point) {
    return point.x < -kBefore && point.x > -kBeforeUpTo && std::abs(point.y) < kBeforeAside;
  });
}

Velocity2D DockController::MakeWay(const DockInput& input) {
  has_made_way_ = true;
  return DriveOut(input, settings_.way_distance);
}

// Where it drives out to, in base_link.
Pose2D DockController::Stage(const DockInput& input) const {
  return RelativeTo(input.pose, Compose(*station_, Pose2D{-stage_at_, 0, 0}));
}

// To where the station should be; round and round if that is not known.
Velocity2D DockController::TurnTowards(const DockInput& input, double seconds) {
  if (!station_) return Turn(M_PI, seconds);
  const Pose2D goal = RelativeTo(input.pose, Landmark());
  const double angle = std::atan2(goal.y, goal.x);
  return std::abs(angle) < kInSight ? Stand() : Turn(angle, seconds);
}

Velocity2D DockController::Plan(const DockInput& input) {
  const Pose2D in_station = InStation(input);
  const double away = std::hypot(in_station.x + settings_.staging_distance, in_station.y);
  if (away > settings_.farthest_start &&
      std::hypot(in_station.x, in_station.y) > settings_.staging_distance) {
    return Fail(Print("the robot is %.2f m from the staging pose, too far for docking", away));
  }
  const auto obstacles = WithoutStation(input.obstacles, in_station, settings_.landmark);
  path_ = PlanDockPath(in_station, Offset(), obstacles, settings_);
  if (!path_) return NoWay(input);
  along_ = 0;
  Enter(Phase::kTurnToPath, input);
  return velocity_;
}

// Out of a narrow place, or round what stands there; else it waits.
Velocity2D DockController::NoWay(const DockInput& input) {
  const Pose2D in_station = InStation(input);
  if (input.now - entered_ > settings_.obstacle_patience) {
    return AttemptFailed(input, "an obstacle stands before the station");
  }
  if (IsToMakeWay(input, input.now - entered_)) return MakeWay(input);
  if (has_staged_ || input.now - entered_ < kWaitForWay) return Stand();
  const bool inside = in_station.x > -settings_.retry_distance;
  const bool faces_it = std::abs(in_station.yaw) < kFacing;
  if (!inside || !faces_it) return DriveOut(input, settings_.staging_distance);
  has_staged_ = true;
  Enter(Phase::kBackOut, input);
  return velocity_;
}

Velocity2D DockController::TurnToStaging(const DockInput& input, double seconds) {
  const Pose2D goal = Stage(input);
  const double angle = std::atan2(goal.y, goal.x);
  if (std::hypot(goal.x, goal.y) < kAtStaging) {
    Enter(Phase::kLook, input);
  } else if (std::abs(angle) < 0.05) {
    Enter(Phase::kDriveToStaging, input);
  } else if (IsLate(input)) {
    return Fail("cannot turn to the staging pose");
  } else {
    return Turn(angle, seconds);
  }
  return velocity_;
}

Velocity2D DockController::DriveToStaging(const DockInput& input, double seconds) {
  const Pose2D goal = Stage(input);
  const double away = std::hypot(goal.x, goal.y);
  const double angle = std::atan2(goal.y, goal.x);
  if (away < kAtStaging) {
    Enter(Phase::kLook, input);
    return velocity_;
  }
  if (std::abs(angle) > 1) {  // passed at the side
    Enter(Phase::kTurnToStaging, input);
    return velocity_;
  }
  if (IsLate(input)) {
    return AttemptFailed(input, Print("cannot reach the staging pose, %.2f m before it", away));
  }
  const bool held =
      std::any_of(input.obstacles.begin(), input.obstacles.end(), [&](const Point2D& point) {
        return std::abs(point.y) < settings_.robot_radius && point.x > 0 &&
               std::hypot(point.x, point.y) < settings_.robot_radius + 0.12;
      });
  if (held) {
    if (HeldFor(input) < kStagingHeld) return Stand();
    Enter(Phase::kLook, input);
    return velocity_;
  }
  DrivesOn(input);
  const double speed = std::min(settings_.align_speed, std::sqrt(settings_.acceleration * away));
  velocity_.linear = LimitChange(velocity_.linear, speed, settings_.acceleration, seconds);
  velocity_.angular = std::clamp(1.5 * angle, -settings_.turn_speed, settings_.turn_speed);
  return velocity_;
}

Velocity2D DockController::TurnToPath(const DockInput& input, double seconds) {
  const double angle = NormalizeAngle(path_->curve.from.yaw - InStation(input).yaw);
  if (std::abs(angle) < kAligned) {
    Enter(Phase::kFollowPath, input);
    return velocity_;
  }
  if (IsLate(input)) return AttemptFailed(input, "cannot turn to its way");
  return Turn(angle, seconds);
}

// Straight into the station.
bool DockController::OnLastStretch() const { return along_ > path_->curve.length() - 0.02; }

// Something in the way just ahead; or it must see the landmark now, and does not.
bool DockController::IsHeld(const DockInput& input, const Pose2D& in_station) {
  const bool must_see = OnLastStretch() && -in_station.x > kNoMoreNeeded;
  if (must_see && input.now - input.seen.value_or(StationSighting()).stamp > kBlind) return true;
  const auto obstacles = WithoutStation(input.obstacles, in_station, settings_.landmark);
  const double end = std::min(along_ + kNoticeAhead, path_->length());
  return IsBlocked(*path_, along_, end, obstacles, settings_, kDrivenMargin);
}

// By an obstacle, and since then it has not come far [s].
double DockController::HeldFor(const DockInput& input) {
  if (held_since_ < 0) {
    held_since_ = input.now;
    held_at_ = input.pose;
  }
  return input.now - held_since_;
}

void DockController::DrivesOn(const DockInput& input) {
  if (Distance(input.pose, held_at_) > kHasDrivenOn) held_since_ = -1;
}

// Whether the way in has come to its end, one way or another; phase_ tells.
Velocity2D DockController::ArriveOrGiveUp(const DockInput& input, const Pose2D& in_station) {
  const double left = OnLastStretch() ? -in_station.x : path_->length() - along_;
  const bool stalled = Stalled(input);
  if (left < kAtContact || (stalled && left < kNearContact) || Charging(input)) {
    Enter(Phase::kWaitForCurrent, input);
  } else if (stalled) {
    return AttemptFailed(input, Print("the robot is stuck %.2f m before the station", left));
  } else if (IsLate(input)) {
    return AttemptFailed(input,
                         Print("the robot has not arrived, %.2f m before the station", left));
  } else if (left < kCheckAt && (std::abs(in_station.y - Offset()) > kMostAside ||
                                 std::abs(in_station.yaw) > kMostTurned)) {
    return AttemptFailed(input, "the robot is not straight before the contacts");
  }
  return velocity_;
}

// Until what is in the way has gone, or another way is free.
Velocity2D DockController::WaitOrGoRound(const DockInput& input) {
  const double held = HeldFor(input);
  if (held > settings_.obstacle_patience) {
    return AttemptFailed(input, "an obstacle stands before the station");
  }
  if (IsToMakeWay(input, held)) return MakeWay(input);
  if (held < kGoRoundAfter || ways_round_ >= kMostWaysRound ||
      input.now - last_plan_ < kPlanAgain) {
    return Stand();
  }
  last_plan_ = input.now;
  const Pose2D in_station = InStation(input);
  const auto obstacles = WithoutStation(input.obstacles, in_station, settings_.landmark);
  const auto path = PlanDockPath(in_station, Offset(), obstacles, settings_);
  if (!path) return Stand();
  ++ways_round_;
  path_ = path;
  along_ = 0;
  Enter(Phase::kTurnToPath, input);
  return velocity_;
}

Velocity2D DockController::FollowPath(const DockInput& input, double seconds) {
  const Pose2D in_station = InStation(input);
  along_ = path_->Nearest({in_station.x, in_station.y}, along_, 0.3);
  ArriveOrGiveUp(input, in_station);
  if (phase_ != Phase::kFollowPath) return velocity_;
  if (Distance(path_->At(along_), in_station) > kLeftPath) {
    Enter(Phase::kLook, input);
    return velocity_;
  }
  if (IsHeld(input, in_station)) return WaitOrGoRound(input);
  DrivesOn(input);
  const double left = path_->length() - along_;
  const bool slowly = left < kSlowFrom || in_station.x > -kSlowBeside;
  const double speed = std::min(slowly ? settings_.approach_speed : settings_.align_speed,
                                std::max(0.03, std::sqrt(0.5 * settings_.acceleration * left)));
  const double lookahead = OnLastStretch() ? settings_.last_lookahead : settings_.lookahead;
  const Pose2D ahead = path_->At(along_ + lookahead);
  return Pursue(RelativeTo(in_station, Point2D{ahead.x, ahead.y}), speed, seconds);
}

}  // namespace coppice::robot::docking
