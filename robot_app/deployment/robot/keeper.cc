#include "robot_app/deployment/robot/keeper.h"

#include <utility>

namespace coppice::robot::deployment {
namespace {

constexpr double kShortestStand = 30;  // s
constexpr double kSamplePeriod = 600;  // s, of the battery

}  // namespace

Keeper::Keeper(World& world, MovingClock& moving, const Programs& programs, Helpers& helpers)
    : world_(world), moving_(moving), programs_(programs), helpers_(helpers) {
  world_.progress = world_.now();
}

Activity Keeper::ActivityNow(bool in_trouble) const {
  if (world_.is_off) return Activity::kOff;
  if (world_.docked) {
    if (!world_.has_current) return Activity::kNoCurrent;
    return world_.battery.full() ? Activity::kFull : Activity::kCharging;
  }
  if (helpers_.is_asking()) return Activity::kAsking;
  return in_trouble ? Activity::kRecovering : Activity::kMoving;
}

void Keeper::Note(bool in_trouble, bool is_going_home) {
  const Activity activity = ActivityNow(in_trouble);
  std::vector<Span>& spans = world_.journal.spans;
  const Time now = world_.now();
  if (spans.empty() || spans.back().activity != activity) {
    if (!spans.empty()) spans.back().when.to = now;
    spans.push_back({{now, now}, activity});
  }
  moving_.SetMoving(activity == Activity::kMoving);
  if (SecondsOf({sampled_, now}) >= kSamplePeriod) {
    world_.journal.battery.push_back({now, world_.battery.state_of_charge()});
    sampled_ = now;
  }
  NoteStanding(activity);
  Watch(activity, is_going_home);
}

void Keeper::NoteStanding(Activity activity) {
  const bool stands = IsUndocked(activity) && !world_.rolls;
  if (stands && !stands_since_) stands_since_ = world_.now();
  if (stands || !stands_since_) return;
  const Interval stand{*stands_since_, world_.now()};
  if (SecondsOf(stand) >= kShortestStand) world_.journal.stands.push_back(stand);
  stands_since_.reset();
}

void Keeper::Watch(Activity activity, bool is_going_home) {
  const bool is_low = world_.battery.state_of_charge() < world_.scenario.low_battery_seen;
  const bool is_neglected =
      IsUndocked(activity) && is_low && !is_going_home && activity != Activity::kAsking;
  const bool is_well = world_.rolls || activity == Activity::kCharging ||
                       activity == Activity::kFull || activity == Activity::kAsking ||
                       helpers_.is_asking();
  if (is_well && !is_neglected) {
    world_.progress = world_.now();
    if (coming_) world_.events.Cancel(*coming_);
    coming_.reset();
    return;
  }
  const double stands = SecondsOf({world_.progress, world_.now()});
  if (coming_ || (!is_neglected && stands < world_.scenario.notice_after)) return;
  cause_ = Cause();
  what_ = is_neglected                       ? "it does not go home although its battery is low"
          : activity == Activity::kOff       ? "it is off"
          : activity == Activity::kNoCurrent ? "it stands on its station without charging"
                                             : "it stands and says nothing";
  coming_ = world_.After(helpers_.TimeToAct(world_.scenario.notice_median), [this] {
    coming_.reset();
    Intervene();
  });
}

std::string Keeper::Cause() const {
  if (programs_.loops()) return "crash_loop";
  if (world_.is_off && world_.battery.state_of_charge() < 0.02) {
    return world_.battery_key_is_stuck ? "charge_signal" : "battery";
  }
  if (world_.is_off) return "docking";
  if (world_.docked && !world_.has_current) return "no_current";
  if (world_.battery_key_is_stuck &&
      world_.battery.state_of_charge() < world_.scenario.low_battery_seen) {
    return "charge_signal";
  }
  if (world_.station_is_broken) return "docking";
  if (world_.loss != Loss::kNone) return "localization";
  if (world_.hindrance != Hindrance::kNone) return "blockage";
  return "program";
}

void Keeper::OnLoopNoticed() {
  cause_ = "crash_loop";
  what_ = "programs are restarted again and again";
  Intervene();
}

void Keeper::Intervene() {
  world_.journal.stops.push_back({world_.now(), cause_, what_});
  world_.progress = world_.now();
  if (on_intervention) on_intervention();
}

void Keeper::Close() {
  if (!world_.journal.spans.empty()) world_.journal.spans.back().when.to = world_.now();
}

}  // namespace coppice::robot::deployment
