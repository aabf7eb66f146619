#include "robot_app/deployment/robot/drive.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::robot::deployment {
namespace {

using leaves::ActionResult;

constexpr char kNode[] = "/navigation";
// So soon an adapter says that its server is gone.
constexpr double kGone = 1;
constexpr double kReached = 0.3;  // m

// The place so far along a way, looking along it.
Pose2D PlaceOn(const FloorWays::Way& way, double along) {
  Pose2D place;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = Distance(way[i - 1], way[i]);
    const double share = length > 0 ? std::min(1.0, along / length) : 1;
    place = {way[i - 1].x + share * (way[i].x - way[i - 1].x),
             way[i - 1].y + share * (way[i].y - way[i - 1].y),
             std::atan2(way[i].y - way[i - 1].y, way[i].x - way[i - 1].x)};
    if (along <= length) break;
    along -= length;
  }
  return place;
}

}  // namespace

Drive::Drive(World& world, FloorWays& ways, const Programs& programs, double abort_after)
    : world_(world),
      ways_(ways),
      programs_(programs),
      abort_after_(abort_after),
      phase_since_(world.now()) {}

bool Drive::Runs() const { return programs_.Works(kNode); }

void Drive::NavigateTo(const leaves::Pose2D& goal, Sender<ActionResult> done) {
  CancelNavigation();
  done_ = done;
  goal_ = goal;
  if (!Runs()) {
    abort_ = world_.After(kGone, [this] { Finish(false, "the server is gone"); });
    return;
  }
  BeginWay();
}

void Drive::CancelNavigation() {
  if (!goal_) return;
  TakePlace();
  world_.events.Cancel(arrival_);
  world_.events.Cancel(abort_);
  goal_.reset();
  way_.clear();
  is_held_ = false;
  world_.rolls = false;
  SetPhase(Phase::kIdle, "no goal");
}

void Drive::BeginWay() {
  along_ = 0;
  way_ = ways_.Find(world_.pose, *goal_);
  is_held_ = false;
  SetPhase(Phase::kDriving, "");
  if (Distance(world_.pose, *goal_) < kReached) {
    arrival_ = world_.After(0.5, [this] { Finish(true, ""); });
    return;
  }
  Review();
}

std::string Drive::WhyHeld() const {
  if (world_.docked) return "in the station";
  if (!programs_.Works("/localization") || !programs_.Works("/odometry_filter") ||
      programs_.Rate("/simulator") <= 0) {
    return "sensors are silent";
  }
  if (way_.empty()) return "no path";
  if (!programs_.Works("/velocity_mux")) return "the wheels do not turn";
  if (world_.hindrance != Hindrance::kNone && world_.hindrance != Hindrance::kClosed) {
    return "an obstacle";
  }
  return {};
}

void Drive::Review() {
  if (!goal_) return;
  if (!Runs()) {
    TakePlace();
    world_.rolls = false;
    world_.events.Cancel(arrival_);
    world_.events.Cancel(abort_);
    abort_ = world_.After(kGone, [this] { Finish(false, "the server is gone"); });
    is_held_ = true;
    return;
  }
  // A robot that is lost, or turns, stands; nobody blames the way for that.
  const bool waits = world_.loss != Loss::kNone || is_in_motion_;
  const std::string why = waits ? "" : WhyHeld();
  if (!why.empty()) return Hold(why);
  if (waits) {
    TakePlace();
    world_.rolls = false;
    world_.events.Cancel(arrival_);
    return;
  }
  Roll();
}

void Drive::Roll() {
  if (world_.rolls) return;
  if (is_held_) {
    world_.events.Cancel(abort_);
    is_held_ = false;
    SetPhase(Phase::kDriving, "");
  }
  world_.rolls = true;
  rolls_since_ = world_.now();
  const double left = std::max(0.0, navigation::PathLength(way_) - along_);
  arrival_ = world_.After(left / world_.scenario.effective_speed, [this] { Finish(true, ""); });
}

void Drive::Hold(const std::string& why) {
  TakePlace();
  world_.rolls = false;
  world_.events.Cancel(arrival_);
  if (is_held_ && message_ == why) return;
  world_.events.Cancel(abort_);
  is_held_ = true;
  SetPhase(why == "no path" ? Phase::kNoPath : Phase::kBlocked, why);
  abort_ = world_.After(abort_after_, [this, why] { Finish(false, why); });
}

void Drive::TakePlace() {
  if (!world_.rolls) return;
  const double driven = SecondsOf({rolls_since_, world_.now()}) * world_.scenario.effective_speed;
  along_ += driven;
  world_.journal.distance += driven;
  rolls_since_ = world_.now();
  if (way_.size() > 1) world_.pose = PlaceOn(way_, along_);
}

void Drive::Finish(bool ok, const std::string& message) {
  TakePlace();
  world_.events.Cancel(arrival_);
  world_.events.Cancel(abort_);
  if (ok) {
    world_.pose = *goal_;
    failures_ = 0;
  } else {
    ++failures_;
  }
  goal_.reset();
  way_.clear();
  is_held_ = false;
  world_.rolls = false;
  SetPhase(Phase::kIdle, message);
  done_.Send({ok, message});
}

void Drive::SetPhase(Phase phase, const std::string& message) {
  if (phase != phase_) phase_since_ = world_.now();
  phase_ = phase;
  message_ = message;
}

monitoring::NavigationReport Drive::report() const {
  return {phase_, world_.now() - phase_since_, failures_, message_};
}

FloorWays::Way Drive::WayLeft() const {
  FloorWays::Way left;
  double before = 0;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    if (i > 0) before += Distance(way_[i - 1], way_[i]);
    if (before >= along_) left.push_back(way_[i]);
  }
  return left;
}

void Drive::FindWay(const leaves::Pose2D& goal, Sender<ActionResult> done) {
  const bool found = Runs() && !ways_.Find(world_.pose, goal).empty();
  done.Send({found, found ? "" : "there is no way right now"});
}

void Drive::BeginMotion(double seconds, std::function<void()> at_end, Sender<ActionResult> done) {
  world_.events.Cancel(motion_end_);
  motion_done_ = done;
  if (!Runs() || !programs_.Works("/velocity_mux") || world_.docked) {
    motion_end_ = world_.After(kGone, [done] { done.Send({false, "the server is gone"}); });
    return;
  }
  is_in_motion_ = true;
  Review();
  motion_end_ = world_.After(seconds, [this, at_end = std::move(at_end)] {
    is_in_motion_ = false;
    at_end();
    motion_done_.Send({true, ""});
    Review();
  });
}

void Drive::Move(double distance, double speed, Sender<ActionResult> done) {
  const auto at_end = [this, distance] {
    // Along the way that it has come, where there is room.
    if (way_.size() > 1 && along_ + distance >= 0) {
      along_ += distance;
      world_.pose = PlaceOn(way_, along_);
      world_.journal.distance += std::abs(distance);
    }
    if (on_moved) on_moved(distance);
  };
  BeginMotion(std::abs(distance) / speed + 1, at_end, done);
}

void Drive::Rotate(double angle, double speed, Sender<ActionResult> done) {
  BeginMotion(
      std::abs(angle) / speed,
      [this] {
        if (on_rotated) on_rotated();
      },
      done);
}

void Drive::CancelMotion() {
  world_.events.Cancel(motion_end_);
  is_in_motion_ = false;
  Review();
}

void Drive::PutAt(const Pose2D& pose) {
  TakePlace();
  world_.pose = pose;
  if (!goal_ || !Runs()) return;
  world_.rolls = false;
  world_.events.Cancel(arrival_);
  BeginWay();
}

}  // namespace coppice::robot::deployment
