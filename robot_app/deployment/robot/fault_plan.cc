#include "robot_app/deployment/robot/fault_plan.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace coppice::robot::deployment {
namespace {

constexpr double kHour = 3600;
constexpr double kMostCrowd = 2;    // times the mean
constexpr int kPublishedDays = 12;  // that rates per deployment are of
// A robot that was freed is held again within this [s in motion].
constexpr double kAgainFrom = 5, kAgainTo = 40;
constexpr double kNotRolling = 2;  // s; looked at again
constexpr double kFreedBy = 0.2;   // m, backwards
constexpr double kSlowRate = 0.3;  // of a slow publisher

// What does not fail: the processes that stand for the hardware, and who watches and repairs. Of
// the latter no failure was seen in the published deployment, so there is no rate for it.
constexpr const char* kSpared[] = {"/simulator",         "/simulated_cameras",  "/coppice_robot",
                                   "/health_aggregator", "/node_monitor",       "/topic_monitor",
                                   "/power_monitor",     "/navigation_monitor", "/system_monitor",
                                   "/assistance"};

}  // namespace

FaultPlan::FaultPlan(World& world, MovingClock& moving, FloorWays& ways, Drive& drive,
                     Position& position, Programs& programs)
    : world_(world),
      moving_(moving),
      ways_(ways),
      drive_(drive),
      position_(position),
      programs_(programs),
      blockages_(world.seed, "blockage"),
      losses_(world.seed, "localization"),
      failures_(world.seed, "program"),
      topics_(world.seed, "topic"),
      rare_(world.seed, "rare"),
      faces_(world.seed, "faces"),
      sight_(world.seed, "sight") {}

void FaultPlan::Begin() {
  PerHour(Fault::kBlockage, blockages_, &FaultPlan::BeginHindrance);
  PerHour(Fault::kLocalization, losses_, &FaultPlan::LosePosition);
  PerHour(Fault::kProgram, failures_, &FaultPlan::FailProgram);
  PerHour(Fault::kTopic, topics_, &FaultPlan::FailTopic);
  Faces();
  PerDeployment(Fault::kCrashLoop, true, [this] {
    if (world_.is_off) return;
    Note(Fault::kCrashLoop, "/odometry_filter");
    programs_.BeginCrashLoop("/odometry_filter", rare_.Happens(world_.scenario.loop_in_program));
    Tell();
  });
  // While it drives: on the station it would only stay there.
  PerDeployment(Fault::kChargeSignal, true, [this] {
    moving_.After(1, [this] {
      world_.battery_key_is_stuck = true;
      Note(Fault::kChargeSignal, "stuck");
      Tell();
    });
  });
  PerDeployment(Fault::kNetwork, false, [this] {
    world_.network = false;
    Note(Fault::kNetwork, "down");
    world_.After(rare_.LogNormal(world_.scenario.network_median, 1), [this] {
      world_.network = true;
      Tell();
    });
    Tell();
  });
}

void FaultPlan::PerHour(Fault fault, Chance& chance, Act act) {
  const bool by_crowd = fault == Fault::kBlockage;
  const double rate = world_.scenario.rate(fault) * (by_crowd ? kMostCrowd : 1);
  if (rate <= 0) return;
  moving_.After(chance.Exponential(kHour / rate), [this, fault, by_crowd, &chance, act] {
    // Thinned (P. Lewis, G. Shedler, 1979): the rate follows the crowd, its mean stays.
    if (!by_crowd || chance.Happens(Crowd() / kMostCrowd)) (this->*act)();
    PerHour(fault, chance, act);
  });
}

Time FaultPlan::SomeTime(Chance& chance, bool on_duty) const {
  const Calendar& calendar = world_.scenario.calendar;
  if (!on_duty)
    return calendar.span().from + Seconds(chance.Uniform() * SecondsOf(calendar.span()));
  double left = 0;
  for (const Interval& duty : calendar.duties()) left += SecondsOf(duty);
  left *= chance.Uniform();
  for (const Interval& duty : calendar.duties()) {
    if (left < SecondsOf(duty)) return duty.from + Seconds(left);
    left -= SecondsOf(duty);
  }
  return calendar.span().to;
}

void FaultPlan::PerDeployment(Fault fault, bool on_duty, std::function<void()> act) {
  Chance chance(world_.seed, ToString(fault));
  const double mean =
      world_.scenario.rate(fault) * world_.scenario.calendar.working_days() / kPublishedDays;
  for (int i = chance.Poisson(mean); i > 0; --i) {
    world_.events.At(SomeTime(chance, on_duty), act);
  }
}

// How much is going on now, over the mean of the hours in which something is.
double FaultPlan::Crowd() const {
  const auto& weights = world_.scenario.people_by_hour;
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const auto hours = std::count_if(weights.begin(), weights.end(), [](double w) { return w > 0; });
  if (hours == 0) return 1;
  const double second = SecondsOf({DayAt(world_.now()).from, world_.now()});
  return weights[static_cast<std::size_t>(second / kHour)] * static_cast<double>(hours) / sum;
}

void FaultPlan::Faces() {
  const double rate = world_.scenario.faces_per_hour * std::max(0.05, Crowd());
  if (rate <= 0) return;
  moving_.After(faces_.Exponential(kHour / rate), [this] {
    const bool has_mask = !faces_.Happens(world_.scenario.faces_without_mask);
    ++(has_mask ? world_.journal.with_mask : world_.journal.without_mask);
    if (on_face) on_face(has_mask);
    Faces();
  });
}

void FaultPlan::Note(Fault fault, const std::string& what, double lasts) {
  world_.journal.faults.push_back({world_.now(), ToString(fault), what, lasts});
}

// ---- what holds the robot

void FaultPlan::BeginHindrance() {
  if (world_.hindrance != Hindrance::kNone || !world_.rolls) {
    moving_.After(kNotRolling, [this] { BeginHindrance(); });
    return;
  }
  const Scenario& s = world_.scenario;
  const double closed = std::max(0.0, 1 - s.blockage_passing - s.blockage_trap);
  const std::size_t kind = blockages_.Pick({s.blockage_passing, s.blockage_trap, closed});
  const double lasts = blockages_.Uniform(s.passing_shortest, s.passing_longest);
  if (kind == 2 && BeginClosed()) return;
  const bool is_trap = kind == 1;
  world_.hindrance = is_trap ? Hindrance::kTrap : Hindrance::kPassing;
  Note(Fault::kBlockage, is_trap ? "trap" : "passing", is_trap ? 0 : lasts);
  if (world_.hindrance == Hindrance::kPassing) {
    world_.is_noticed = sight_.Happens(world_.scenario.people_noticed);
    clears_ = world_.After(lasts, [this] { ClearHindrance(); });
  }
  drive_.Review();
  Tell();
}

// A door or a fire door on the way ahead; false if there is none.
bool FaultPlan::BeginClosed() {
  const FloorWays::Way way = drive_.WayLeft();
  const bool at_door = blockages_.Happens(world_.scenario.closed_at_door);
  const double lasts = blockages_.Exponential(world_.scenario.closed_lasts);
  std::string name = ways_.PassedBy(way, 1, at_door);
  if (name.empty()) name = ways_.PassedBy(way, 1, !at_door);
  if (name.empty()) return false;
  world_.hindrance = Hindrance::kClosed;
  world_.closed = name;
  Note(Fault::kBlockage, name, lasts);
  ways_.Close(name);
  clears_ = world_.After(lasts, [this] { ClearHindrance(); });
  drive_.PutAt(world_.pose);  // it sees it, and plans anew
  Tell();
  return true;
}

void FaultPlan::ClearHindrance() {
  const Hindrance was = std::exchange(world_.hindrance, Hindrance::kNone);
  if (was == Hindrance::kNone) return;
  world_.events.Cancel(clears_);
  double again = was == Hindrance::kPassing ? world_.scenario.again_after_passing : 0;
  if (was == Hindrance::kTrap) again = world_.scenario.again_after_trap;
  if (was == Hindrance::kClosed) {
    ways_.Open(world_.closed);
    world_.closed.clear();
    if (drive_.has_goal()) drive_.PutAt(world_.pose);
  }
  if (blockages_.Happens(again)) {
    moving_.After(blockages_.Uniform(kAgainFrom, kAgainTo), [this] { BeginHindrance(); });
  }
  drive_.Review();
  Tell();
}

void FaultPlan::OnMoved(double distance) {
  if (world_.hindrance == Hindrance::kTrap && distance <= -kFreedBy) ClearHindrance();
}

// ---- the others

void FaultPlan::LosePosition() {
  const Scenario& s = world_.scenario;
  const double outside = std::max(0.0, 1 - s.lost_transient - s.lost_inside);
  const std::size_t kind = losses_.Pick({s.lost_transient, s.lost_inside, outside});
  constexpr const char* kLosses[] = {"transient", "inside", "outside"};
  Note(Fault::kLocalization, kLosses[kind]);
  position_.Lose(kind == 0 ? Loss::kTransient : kind == 1 ? Loss::kInside : Loss::kOutside);
  Tell();
}

std::string FaultPlan::SomeNode(Chance& chance) const {
  std::vector<std::string> nodes;
  for (const std::string& node : programs_.nodes()) {
    const bool is_spared =
        std::find(std::begin(kSpared), std::end(kSpared), node) != std::end(kSpared);
    if (!is_spared && programs_.Works(node)) nodes.push_back(node);
  }
  if (nodes.empty()) return {};
  return nodes[chance.Pick(std::vector<double>(nodes.size(), 1.0))];
}

void FaultPlan::FailProgram() {
  const std::string node = SomeNode(failures_);
  const bool hangs = failures_.Happens(world_.scenario.hang_share);
  Note(Fault::kProgram, (hangs ? "hang " : "exit ") + node);
  if (hangs) {
    programs_.Hang(node);
  } else {
    programs_.Crash(node, "exit");
  }
  Tell();
}

void FaultPlan::FailTopic() {
  const bool is_silent = topics_.Happens(0.5);
  Note(Fault::kTopic, is_silent ? "silent" : "slow");
  programs_.Slow("/simulator", is_silent ? 0 : kSlowRate);
  Tell();
}

}  // namespace coppice::robot::deployment
