// Breaks things on purpose, and heals them after a while of simulated time.
//
// The requests are those of robot_app/srv/InjectFault.srv. What concerns the floor and the battery
// is done on the World; what is wrong with the sensors' messages is kept here for the node to ask;
// signals to other nodes go through a function that the owner provides.
#ifndef COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_
#define COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "robot_app/simulation/sensor_faults.h"
#include "robot_app/simulation/world.h"

namespace coppice::robot::simulation {

struct Fault {
  std::string fault;    ///< what to do, for example "block_corridor"
  std::string target;   ///< the place, door, node or topic; a waypoint or "X Y YAW"
  double value = 0;     ///< charge 0..1, offset [m] or factor of a rate, as the fault needs it
  double duration = 0;  ///< s of simulated time until it heals by itself; 0 = never
};

/// Sends a signal (SIGKILL, SIGSTOP, SIGCONT) to the process of a ROS node.
using SignalNode = std::function<Change(const std::string& node, int signal)>;

class Faults {
 public:
  /// `topics` can be silenced, slowed down and sped up. The world must outlive this object.
  Faults(World& world, std::vector<std::string> topics, SignalNode signal_node);

  /// Does what is asked, or refuses with the reason. Never throws.
  Change Inject(const Fault& fault);

  /// Heals what is due at the world's time; call it after each step. What cannot be healed yet (the
  /// robot stands in the door) is tried again.
  void Update();

  /// How often the message that is due on a topic now is to be sent: 1 when nothing is wrong, 0
  /// while it is silent, now and then 0 while it is slow, more than 1 while it is fast. Call it
  /// once for each message that is due.
  int Copies(const std::string& topic);

  /// What is wrong with the sensors themselves.
  const SensorFaults& sensors() const { return sensors_; }

  /// The battery's measured values stand still, though its messages come.
  bool battery_frozen() const { return battery_frozen_; }

 private:
  using Action = Change (Faults::*)(const Fault&);
  struct Kind {
    Action action;
    const char* healed_by;  // the fault that takes it back, or empty
  };
  static const std::map<std::string, Kind>& Kinds();

  Change Block(const Fault& f) { return world_.SetPlaceBlocked(f.target, true); }
  Change Clear(const Fault& f) { return world_.SetPlaceBlocked(f.target, false); }
  Change Open(const Fault& f) { return world_.SetDoorOpen(f.target, true); }
  Change Close(const Fault& f) { return world_.SetDoorOpen(f.target, false); }
  Change SetBattery(const Fault& f) { return world_.SetStateOfCharge(f.value); }
  Change Kidnap(const Fault& f);
  Change BendContacts(const Fault& f) { return world_.SetContactsOffset(f.value); }
  Change MoveStation(const Fault& f);
  Change TakeLandmark(const Fault&) { return world_.SetLandmark(false); }
  Change PutLandmark(const Fault&) { return world_.SetLandmark(true); }
  Change FollowRobot(const Fault& f) { return world_.SetFollows(f.target, true); }
  Change LeaveRobot(const Fault& f) { return world_.SetFollows(f.target, false); }
  Change SwitchChargerOff(const Fault&) { return world_.SetChargerOn(false); }
  Change SwitchChargerOn(const Fault&) { return world_.SetChargerOn(true); }
  Change PressStop(const Fault&) { return world_.SetEmergencyStop(true); }
  Change ReleaseStop(const Fault&) { return world_.SetEmergencyStop(false); }
  Change FreezeBattery(const Fault& f);
  Change ThawBattery(const Fault& f);
  Change Kill(const Fault& f);
  Change Hang(const Fault& f);
  Change Resume(const Fault& f);
  Change Silence(const Fault& f);
  Change Slow(const Fault& f);
  Change Hasten(const Fault& f);
  Change Restore(const Fault& f);
  Change Delay(const Fault& f);
  Change Blind(const Fault& f);
  Change LoseRing(const Fault& f);
  Change FindRings(const Fault& f);
  Change Cover(const Fault& f);
  Change Uncover(const Fault& f);
  Change Wear(const Fault& f);
  Change Mend(const Fault& f);
  Change SetRate(const std::string& topic, double factor);
  Outcome CheckTopic(const std::string& topic) const;
  static Outcome CheckCamera(const std::string& camera);

  struct Rate {
    double factor;
    double due = 0;  // messages, the part of one that is left over
  };
  struct Healing {
    double time;
    Fault fault;
  };
  World& world_;
  std::vector<std::string> topics_;
  SignalNode signal_node_;
  std::map<std::string, Rate> rates_;  // of topics that do not come as they should
  SensorFaults sensors_;
  bool battery_frozen_ = false;
  std::vector<Healing> healings_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_
