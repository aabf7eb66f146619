#include "robot_app/simulation/faults.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kMostHaste = 20;      // times the rate of a topic
constexpr double kMostLag = 10;        // s
constexpr double kFastestWear = 3600;  // all rows within a second
constexpr std::array<const char*, 6> kWithoutReadings = {
    "/scan", "/velodyne_points", "/imu/data", "/sonar/left", "/sonar/front", "/sonar/right"};

// "X Y YAW"; nothing if it is none.
std::optional<Pose2> ToPose(const std::string& text) {
  Pose2 pose;
  char rest = 0;
  const int read = std::sscanf(text.c_str(), "%lf %lf %lf %c", &pose.x, &pose.y, &pose.yaw, &rest);
  return read == 3 ? std::optional(pose) : std::nullopt;
}

}  // namespace

const std::map<std::string, Faults::Kind>& Faults::Kinds() {
  static const std::map<std::string, Kind> kinds = {
      {"block_corridor", {&Faults::Block, "clear_corridor"}},
      {"clear_corridor", {&Faults::Clear, "block_corridor"}},
      {"open_door", {&Faults::Open, "close_door"}},
      {"close_door", {&Faults::Close, "open_door"}},
      {"set_battery", {&Faults::SetBattery, ""}},
      {"freeze_battery", {&Faults::FreezeBattery, "thaw_battery"}},
      {"thaw_battery", {&Faults::ThawBattery, "freeze_battery"}},
      {"contact_without_current", {&Faults::SwitchChargerOff, "restore_current"}},
      {"restore_current", {&Faults::SwitchChargerOn, "contact_without_current"}},
      {"docking_offset", {&Faults::BendContacts, "docking_offset"}},
      {"move_station", {&Faults::MoveStation, ""}},
      {"take_landmark", {&Faults::TakeLandmark, "restore_landmark"}},
      {"restore_landmark", {&Faults::PutLandmark, "take_landmark"}},
      {"emergency_stop", {&Faults::PressStop, "release_emergency_stop"}},
      {"release_emergency_stop", {&Faults::ReleaseStop, "emergency_stop"}},
      {"follow_robot", {&Faults::FollowRobot, "leave_robot"}},
      {"leave_robot", {&Faults::LeaveRobot, "follow_robot"}},
      {"kidnap", {&Faults::Kidnap, ""}},
      {"kill_node", {&Faults::Kill, ""}},
      {"hang_node", {&Faults::Hang, "resume_node"}},
      {"resume_node", {&Faults::Resume, ""}},
      {"silence_topic", {&Faults::Silence, "restore_topic"}},
      {"slow_topic", {&Faults::Slow, "restore_topic"}},
      {"fast_topic", {&Faults::Hasten, "restore_topic"}},
      {"delay_topic", {&Faults::Delay, "restore_topic"}},
      {"blind_topic", {&Faults::Blind, "restore_topic"}},
      {"restore_topic", {&Faults::Restore, "silence_topic"}},
      {"lose_ring", {&Faults::LoseRing, "find_rings"}},
      {"find_rings", {&Faults::FindRings, "lose_ring"}},
      {"cover_lens", {&Faults::Cover, "uncover_lens"}},
      {"uncover_lens", {&Faults::Uncover, "cover_lens"}},
      {"wear_camera", {&Faults::Wear, "mend_camera"}},
      {"mend_camera", {&Faults::Mend, "wear_camera"}},
  };
  return kinds;
}

Faults::Faults(World& world, std::vector<std::string> topics, SignalNode signal_node)
    : world_(world), topics_(std::move(topics)), signal_node_(std::move(signal_node)) {}

Change Faults::Inject(const Fault& fault) {
  const auto kind = Kinds().find(fault.fault);
  if (kind == Kinds().end()) {
    std::vector<std::string> names;
    std::string list;
    for (const auto& [name, unused] : Kinds()) {
      names.push_back(name);
      list += (list.empty() ? "" : ", ") + name;
    }
    const std::string hint = DidYouMean(fault.fault, names);
    return Problem{"unknown fault \"" + fault.fault + "\"" +
                   (hint.empty() ? "; known: " + list : " (" + hint + ")")};
  }
  const std::string healer = kind->second.healed_by;
  if (!(fault.duration >= 0)) return Problem{"the duration must be 0 or more seconds"};
  if (fault.duration > 0 && healer.empty()) {
    return Problem{fault.fault + " does not heal by itself; the duration must be 0"};
  }
  const Change outcome = (this->*kind->second.action)(fault);
  if (!outcome) return outcome;
  // The newest word on a thing counts: what was to happen to it later is forgotten.
  healings_.erase(std::remove_if(healings_.begin(), healings_.end(),
                                 [&](const Healing& h) {
                                   return h.fault.target == fault.target &&
                                          (h.fault.fault == healer || h.fault.fault == fault.fault);
                                 }),
                  healings_.end());
  if (fault.duration > 0) {
    healings_.push_back({world_.time() + fault.duration, {healer, fault.target, 0, 0}});
  }
  return outcome;
}

void Faults::Update() {
  for (std::size_t i = 0; i < healings_.size();) {
    const Healing& due = healings_[i];
    if (due.time > world_.time() || !(this->*Kinds().at(due.fault.fault).action)(due.fault)) {
      ++i;
    } else {
      healings_.erase(healings_.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
}

Change Faults::Kill(const Fault& f) { return signal_node_(f.target, SIGKILL); }
Change Faults::Hang(const Fault& f) { return signal_node_(f.target, SIGSTOP); }
Change Faults::Resume(const Fault& f) { return signal_node_(f.target, SIGCONT); }

Outcome Faults::CheckTopic(const std::string& topic) const {
  if (std::find(topics_.begin(), topics_.end(), topic) != topics_.end()) return {};
  std::string list;
  for (const std::string& name : topics_) list += (list.empty() ? "" : ", ") + name;
  const std::string hint = DidYouMean(topic, topics_);
  return Problem{"the simulator does not publish \"" + topic + "\"" +
                 (hint.empty() ? "; it publishes " + list : " (" + hint + ")")};
}

Change Faults::SetRate(const std::string& topic, double factor) {
  if (const Outcome known = CheckTopic(topic); !known) return Problem{known.problem()};
  rates_[topic] = {factor};
  std::ostringstream message;
  message << topic << " has " << factor << " times its rate";
  return message.str();
}

Change Faults::Silence(const Fault& f) { return SetRate(f.target, 0); }

Change Faults::Slow(const Fault& f) {
  if (!(f.value > 0 && f.value < 1))
    return Problem{"the factor of a slow topic is between 0 and 1"};
  return SetRate(f.target, f.value);
}

Change Faults::Hasten(const Fault& f) {
  if (!(f.value > 1 && f.value <= kMostHaste)) {
    return Problem{"the factor of a fast topic is above 1, 20 at most"};
  }
  return SetRate(f.target, f.value);
}

Change Faults::Restore(const Fault& f) {
  if (const Outcome known = CheckTopic(f.target); !known) return Problem{known.problem()};
  rates_.erase(f.target);
  sensors_.Restore(f.target);
  return f.target + " is published as it should be";
}

int Faults::Copies(const std::string& topic) {
  const auto found = rates_.find(topic);
  if (found == rates_.end()) return 1;
  Rate& rate = found->second;
  rate.due += rate.factor;
  const int copies = static_cast<int>(rate.due + 1e-9);  // ten times 0.3 is 3
  rate.due -= copies;
  return copies;
}

Change Faults::Delay(const Fault& f) {
  if (const Outcome known = CheckTopic(f.target); !known) return Problem{known.problem()};
  if (!(f.value > 0 && f.value <= kMostLag)) {
    return Problem{"the lag of a topic is above 0, 10 s at most"};
  }
  sensors_.SetLag(f.target, f.value);
  std::ostringstream message;
  message << f.target << " comes " << f.value << " s late";
  return message.str();
}

Change Faults::Blind(const Fault& f) {
  const auto& topics = kWithoutReadings;
  if (std::find(topics.begin(), topics.end(), f.target) == topics.end()) {
    std::string list;
    for (const char* topic : topics) list += std::string(list.empty() ? "" : ", ") + topic;
    return Problem{"the readings of \"" + f.target + "\" cannot be taken away, only those of " +
                   list};
  }
  sensors_.SetBlind(f.target);
  return f.target + " has no readings";
}

Change Faults::LoseRing(const Fault& f) {
  const int rings = world_.lidar_3d().options().rings;
  const int ring = static_cast<int>(std::clamp(f.value, -1.0, double(rings)));
  if (ring != f.value || ring < 0 || ring >= rings) {
    return Problem{"the value is a ring of the 3-D lidar, 0 (the lowest) to " +
                   std::to_string(rings - 1)};
  }
  sensors_.LoseRing(ring);
  return "ring " + std::to_string(ring) + " of the 3-D lidar measures nothing";
}

Change Faults::FindRings(const Fault&) {
  sensors_.FindRings();
  return "all rings of the 3-D lidar measure";
}

Outcome Faults::CheckCamera(const std::string& camera) {
  const std::vector<std::string> names(kCameras.begin(), kCameras.end());
  if (std::find(names.begin(), names.end(), camera) != names.end()) return {};
  const std::string hint = DidYouMean(camera, names);
  return Problem{"there is no camera \"" + camera + "\"" +
                 (hint.empty() ? "; the target is front or rear" : " (" + hint + ")")};
}

Change Faults::Cover(const Fault& f) {
  if (const Outcome known = CheckCamera(f.target); !known) return Problem{known.problem()};
  sensors_.SetCovered(f.target, true);
  return "something hangs over the camera " + f.target;
}

Change Faults::Uncover(const Fault& f) {
  if (const Outcome known = CheckCamera(f.target); !known) return Problem{known.problem()};
  sensors_.SetCovered(f.target, false);
  return "the camera " + f.target + " sees again";
}

Change Faults::Wear(const Fault& f) {
  if (const Outcome known = CheckCamera(f.target); !known) return Problem{known.problem()};
  if (!(f.value > 0 && f.value <= kFastestWear)) {
    return Problem{
        "the value is the share of its rows that is damaged more each hour, above 0, "
        "3600 at most"};
  }
  sensors_.Wear(f.target, f.value, world_.time());
  return "the data of the camera " + f.target + " is damaged more and more";
}

Change Faults::Mend(const Fault& f) {
  if (const Outcome known = CheckCamera(f.target); !known) return Problem{known.problem()};
  sensors_.Mend(f.target);
  return "the data of the camera " + f.target + " comes undamaged";
}

Change Faults::FreezeBattery(const Fault&) {
  battery_frozen_ = true;
  return "the battery's values stand still";
}

Change Faults::ThawBattery(const Fault&) {
  battery_frozen_ = false;
  return "the battery's values are measured";
}

Change Faults::MoveStation(const Fault& f) {
  if (const auto pose = ToPose(f.target)) return world_.MoveStation(*pose);
  return Problem{"the target is \"X Y YAW\" as seen by a docked robot, not \"" + f.target + "\""};
}

Change Faults::Kidnap(const Fault& f) {
  std::vector<std::string> names;
  for (const FloorWaypoint& waypoint : world_.floor().waypoints) {
    if (waypoint.name == f.target) return world_.Kidnap(waypoint.pose);
    names.push_back(waypoint.name);
  }
  if (const auto pose = ToPose(f.target)) return world_.Kidnap(*pose);
  const std::string hint = DidYouMean(f.target, names);
  return Problem{"the target is a waypoint of the floor or \"X Y YAW\", not \"" + f.target + "\"" +
                 (hint.empty() ? "" : " (" + hint + ")")};
}

}  // namespace coppice::robot::simulation
