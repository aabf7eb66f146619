// Breaks things on purpose, and heals them after a while of simulated time.
//
// The requests are those of robot_app/srv/InjectFault.srv. What concerns the floor and the battery
// is done on the World; silenced topics are kept here for the node to ask; signals to other nodes
// go through a function that the owner provides.
#ifndef COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_
#define COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot_app/simulation/world.h"

namespace coppice::robot {

struct Fault {
  std::string fault;    ///< what to do, for example "block_corridor"
  std::string target;   ///< the place, door, node or topic
  double value = 0;     ///< for set_battery: 0..1
  double duration = 0;  ///< s of simulated time until it heals by itself; 0 = never
};

/// Sends a signal (SIGKILL, SIGSTOP, SIGCONT) to the process of a ROS node.
using SignalNode = std::function<Outcome(const std::string& node, int signal)>;

class Faults {
 public:
  /// `topics` can be silenced. The world must outlive this object.
  Faults(World& world, std::vector<std::string> topics, SignalNode signal_node);

  /// Does what is asked, or refuses with the reason. Never throws.
  Outcome Inject(const Fault& fault);

  /// Heals what is due at the world's time; call it after each step. What cannot be healed yet (the
  /// robot stands in the door) is tried again.
  void Update();

  bool silenced(const std::string& topic) const { return silenced_.count(topic) > 0; }

 private:
  using Action = Outcome (Faults::*)(const Fault&);
  struct Kind {
    Action action;
    const char* healed_by;  // the fault that takes it back, or empty
  };
  static const std::map<std::string, Kind>& Kinds();

  Outcome Block(const Fault& f) { return world_.SetPlaceBlocked(f.target, true); }
  Outcome Clear(const Fault& f) { return world_.SetPlaceBlocked(f.target, false); }
  Outcome Open(const Fault& f) { return world_.SetDoorOpen(f.target, true); }
  Outcome Close(const Fault& f) { return world_.SetDoorOpen(f.target, false); }
  Outcome SetBattery(const Fault& f) { return world_.SetStateOfCharge(f.value); }
  Outcome Kill(const Fault& f);
  Outcome Hang(const Fault& f);
  Outcome Resume(const Fault& f);
  Outcome Silence(const Fault& f);
  Outcome Restore(const Fault& f);
  Outcome CheckTopic(const std::string& topic) const;

  struct Healing {
    double time;
    Fault fault;
  };
  World& world_;
  std::vector<std::string> topics_;
  SignalNode signal_node_;
  std::set<std::string> silenced_;
  std::vector<Healing> healings_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_SIMULATION_FAULTS_H_
