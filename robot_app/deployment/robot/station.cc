#include "robot_app/deployment/robot/station.h"

#include <utility>

namespace coppice::robot::deployment {
namespace {

using leaves::ActionResult;
using monitoring::GoalPhase;

constexpr double kGone = 1;       // s, until an adapter says that the server is gone
constexpr double kApproach = 45;  // s; measured in the simulated robot
constexpr double kBackOut = 20;   // s
constexpr double kPressOn = 10;   // s
constexpr double kUndock = 15;    // s

}  // namespace

Station::Station(World& world, const Programs& programs, Pose2D docked, Pose2D staging,
                 bool contact_is_success)
    : world_(world),
      programs_(programs),
      docked_(docked),
      staging_(staging),
      contact_is_success_(contact_is_success),
      chance_(world.seed, "docking") {}

void Station::After(double seconds, std::function<void()> event) {
  next_ = world_.After(seconds, [this, event = std::move(event)] {
    if (programs_.Works("/docking") && programs_.Works("/velocity_mux")) return event();
    Finish(false, "the server is gone");
  });
}

void Station::Begin(Sender<ActionResult> done) {
  CancelDocking();
  done_ = done;
  is_busy_ = true;
  failed_ = 0;
  goal_ = {"goal " + std::to_string(++goals_), GoalPhase::kActive, ""};
}

void Station::Finish(bool ok, const std::string& message) {
  is_busy_ = false;
  goal_.phase = ok ? GoalPhase::kSucceeded : GoalPhase::kAborted;
  goal_.message = message;
  done_.Send({ok, message});
}

void Station::CancelDocking() {
  if (!is_busy_) return;
  world_.events.Cancel(next_);
  is_busy_ = false;
  goal_.phase = GoalPhase::kPreempted;
}

Docking* Station::visit() { return visit_is_open_ ? &world_.journal.dockings.back() : nullptr; }

// ---- onto it

void Station::Dock(double, int attempts, Sender<ActionResult> done) {
  Begin(done);
  attempts_left_ = attempts;
  if (!visit()) {
    world_.journal.dockings.push_back({world_.now(), 0, false, false, 0});
    visit_is_open_ = true;
    had_contact_ = false;
  }
  Attempt();
}

void Station::Attempt() {
  --attempts_left_;
  if (visit()) ++visit()->attempts;
  After(kApproach, [this] {
    const bool fails = chance_.Happens(world_.scenario.rate(Fault::kDocking));
    if (fails && chance_.Happens(world_.scenario.docking_persistent)) {
      world_.station_is_broken = true;
    }
    if (fails || world_.station_is_broken) {
      After(kBackOut, [this] { FailAttempt("the station was not reached"); });
    } else {
      Contact();
    }
  });
}

void Station::FailAttempt(const std::string& why) {
  ++failed_;
  if (attempts_left_ > 0) return Attempt();
  Finish(false, why);
}

void Station::Contact() {
  // The first contact of a visit may be a bad one; another is made anew.
  world_.contact_is_bad = !had_contact_ && chance_.Happens(world_.scenario.rate(Fault::kNoCurrent));
  if (world_.contact_is_bad && chance_.Happens(world_.scenario.docking_persistent)) {
    world_.station_has_power = false;
  }
  had_contact_ = true;
  world_.docked = true;
  world_.has_current = !world_.contact_is_bad && world_.station_has_power;
  world_.pose = docked_;
  if (on_contact) on_contact();
  if (visit()) visit()->is_docked = world_.has_current || contact_is_success_;
  if (world_.has_current || contact_is_success_) {
    CloseVisit();
    Finish(true, "");
    return;
  }
  After(kPressOn, [this] {
    TryToPressOn([this] {
      Leave();
      After(kBackOut, [this] { FailAttempt("contact without current"); });
    });
  });
}

void Station::TryToPressOn(std::function<void()> otherwise) {
  if (world_.station_has_power && chance_.Happens(world_.scenario.no_current_press_on)) {
    world_.contact_is_bad = false;
    world_.has_current = true;
    if (on_contact) on_contact();
    CloseVisit();
    Finish(true, "");
  } else {
    otherwise();
  }
}

void Station::PressOn(Sender<ActionResult> done) {
  Begin(done);
  if (!world_.docked) {
    next_ = world_.After(kGone, [this] { Finish(false, "no contact"); });
    return;
  }
  if (world_.has_current) {
    next_ = world_.After(kGone, [this] { Finish(true, ""); });
    return;
  }
  After(kPressOn, [this] { TryToPressOn([this] { Finish(false, "no current"); }); });
}

void Station::CloseVisit() {
  Docking* const open = visit();
  if (!open) return;
  open->is_docked = world_.docked;
  open->has_current = world_.docked && world_.has_current;
  open->seconds = SecondsOf({open->begun, world_.now()});
  visit_is_open_ = false;
}

// ---- off it

void Station::Leave() {
  world_.docked = false;
  world_.has_current = false;
  world_.contact_is_bad = false;
  world_.pose = staging_;
  if (on_contact) on_contact();
}

void Station::Undock(Sender<ActionResult> done) {
  Begin(done);
  After(kUndock, [this] {
    Leave();
    CloseVisit();
    Finish(true, "");
  });
}

void Station::Repair(bool push_onto_it) {
  world_.station_is_broken = false;
  world_.station_has_power = true;
  if (!world_.docked && !push_onto_it) return;
  world_.contact_is_bad = false;
  world_.docked = true;
  world_.has_current = true;
  world_.pose = docked_;
  if (on_contact) on_contact();
  CloseVisit();
}

}  // namespace coppice::robot::deployment
