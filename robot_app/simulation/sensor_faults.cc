#include "robot_app/simulation/sensor_faults.h"

#include <algorithm>

namespace coppice::robot::simulation {

double SensorFaults::Lag(const std::string& topic) const {
  const auto found = lags_.find(topic);
  return found != lags_.end() ? found->second : 0;
}

CameraFault SensorFaults::Of(const std::string& camera, double time) const {
  const auto found = cameras_.find(camera);
  if (found == cameras_.end()) return {};
  const Camera& c = found->second;
  return {c.covered, std::clamp(c.growth * (time - c.worn_since) / 3600, 0.0, 1.0)};
}

void SensorFaults::Wear(const std::string& camera, double growth, double time) {
  cameras_[camera].growth = growth;
  cameras_[camera].worn_since = time;
}

void SensorFaults::Restore(const std::string& topic) {
  lags_.erase(topic);
  blind_.erase(topic);
}

}  // namespace coppice::robot::simulation
