// A ROS graph with the aggregator in it, for tests of the monitors' programs: what they say is seen
// on /monitoring.
#ifndef COPPICE_TESTS_ROBOT_APP_MONITORING_MONITOR_GRAPH_H_
#define COPPICE_TESTS_ROBOT_APP_MONITORING_MONITOR_GRAPH_H_

#include <coppice_msgs/Health.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "tests/robot_app/processes/ros_graph.h"

namespace coppice::robot::monitoring {

using coppice_msgs::HealthEntry;

class MonitorGraphTest : public testing::Test {
 protected:
  explicit MonitorGraphTest(const std::string& config) {
    std::ofstream(config_) << config;
    subscriber_ = graph_.node().subscribe<coppice_msgs::Health>(
        "/monitoring", 100, [this](const coppice_msgs::Health::ConstPtr& message) {
          health_ = *message;
          ++publications_;
        });
    graph_.Start("aggregator",
                 {processes::kPrograms + "coppice-health-aggregator", "--config", config_});
  }
  ~MonitorGraphTest() override { graph_.EndPrograms(); }

  void StartMonitor(const std::string& name) {
    graph_.Start(name, {processes::kPrograms + "coppice-" + name, "--config", config_});
  }
  int StartTalker(const std::string& name, double rate) {
    return graph_.Start(name,
                        {processes::kTestPrograms + "test_talker", "__name:=" + name + "_talker",
                         "_topic:=/" + name, "_rate:=" + std::to_string(rate)});
  }

  const HealthEntry* Find(const std::string& monitor, const std::string& subject) const {
    for (const HealthEntry& entry : health_.entries) {
      if (entry.monitor == monitor && entry.subject == subject) return &entry;
    }
    return nullptr;
  }
  bool WaitForLevel(const std::string& monitor, const std::string& subject, int level) {
    return graph_.WaitFor([&] {
      const HealthEntry* entry = Find(monitor, subject);
      return entry && entry->level == level;
    });
  }

  const std::string config_ = processes::Temporary("monitor_graph.yaml");
  processes::RosGraph& graph_ = processes::RosGraph::Shared();
  ros::Subscriber subscriber_;
  coppice_msgs::Health health_;
  int publications_ = 0;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_TESTS_ROBOT_APP_MONITORING_MONITOR_GRAPH_H_
