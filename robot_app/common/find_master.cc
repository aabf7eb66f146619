#include "robot_app/common/find_master.h"

#include <ros/master.h>

#include <iostream>

#include "robot_app/common/node_probe.h"

namespace coppice::robot {

bool HasMaster() {
  NodeProbe::SilenceLibrary();
  const auto master = ParseUri(ros::master::getURI());
  return master && MasterAnswers(*master, std::chrono::seconds(2));
}

bool FindMaster(const std::string& program) {
  if (HasMaster()) return true;
  std::cerr << program << ": no ROS master at " << ros::master::getURI() << " (ROS_MASTER_URI)\n";
  return false;
}

}  // namespace coppice::robot
