// What is wrong with the sensors themselves, not with the rate of their messages: readings that
// come late or are none, rings of the 3-D lidar that are gone, cameras that see nothing or whose
// data is damaged more and more. Kept by Faults; asked by who publishes.
#ifndef COPPICE_ROBOT_APP_SIMULATION_SENSOR_FAULTS_H_
#define COPPICE_ROBOT_APP_SIMULATION_SENSOR_FAULTS_H_

#include <map>
#include <set>
#include <string>
#include <vector>

#include "robot_app/simulation/camera/camera_fault.h"

namespace coppice::robot::simulation {

class SensorFaults {
 public:
  /// How late the messages of a topic are sent [s]; 0: at once.
  double Lag(const std::string& topic) const;
  /// Every reading of it is no number.
  bool IsBlind(const std::string& topic) const { return blind_.count(topic) > 0; }
  /// Rings that measure nothing.
  const std::set<int>& lost_rings() const { return lost_rings_; }
  /// What ails a camera at a time of the world.
  CameraFault Of(const std::string& camera, double time) const;

  void SetLag(const std::string& topic, double seconds) { lags_[topic] = seconds; }
  void SetBlind(const std::string& topic) { blind_.insert(topic); }
  void LoseRing(int ring) { lost_rings_.insert(ring); }
  void FindRings() { lost_rings_.clear(); }
  void SetCovered(const std::string& camera, bool covered) { cameras_[camera].covered = covered; }
  /// From `time` on, `growth` of its rows more are damaged each hour.
  void Wear(const std::string& camera, double growth, double time);
  void Mend(const std::string& camera) { cameras_[camera].growth = 0; }
  /// The topic's readings are right and in time.
  void Restore(const std::string& topic);

 private:
  struct Camera {
    bool covered = false;
    double growth = 0;  // share of the rows an hour
    double worn_since = 0;
  };
  std::map<std::string, double> lags_;
  std::set<std::string> blind_;
  std::set<int> lost_rings_;
  std::map<std::string, Camera> cameras_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SENSOR_FAULTS_H_
