// What the monitors' programs have in common: the start, the active configuration, the reports.
//
// A monitor reports every report_period of wall time, so that readers notice a silent monitor just
// as fast when simulated time is slow, fast or stands still.
#ifndef COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_
#define COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_

#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robot_app/monitoring/monitor_config.h"
#include "robot_app/monitoring/process_table.h"

namespace coppice::robot::monitoring {

/// With what a monitor was started.
struct MonitorStart {
  MonitorConfig config;
  std::string host;    ///< name of this computer: that of the system unless --host says another
  std::string folder;  ///< --folder: relative paths in the configuration begin here
};

/// Reads `--config FILE [--bands FILE] [--host NAME] [--folder FOLDER]` and starts a ROS node of
/// this name (ROS remappings work). `--help` prints these and ends the program. On a problem prints
/// one line and returns nothing; the program is to end with status 2. SIGTERM and SIGINT end the
/// spinning. A monitor says what it found on its topics and nothing on /rosout, whose thread would
/// wake it ten times per second.
std::optional<MonitorStart> StartMonitor(int argc, char** argv, const std::string& name);

/// As ros::spin, but sleeps as long as nothing comes; ros::spin looks ten times per second.
void SpinWhenCalled();

/// As ros::spin, but takes in what has come only once per `batch`. For a monitor of many messages:
/// to be woken by every one costs far more than to count it.
void SpinInBatches(Duration batch);

/// For the thread that spins.
class MonitorNode {
 public:
  /// `on_list` is called at once and whenever another configuration comes into force.
  MonitorNode(const MonitorStart& start, std::function<void(const WatchList&)> on_list);

  ros::NodeHandle& handle() { return handle_; }
  const std::string& host() const { return start_.host; }
  const ProcessTable& processes() const { return processes_; }
  /// What is watched in the configuration that is in force.
  const WatchList& list() const { return start_.config.ForConfiguration(configuration_); }
  static Times Now();

  /// Calls again and again, in wall time, as long as the timer lives.
  ros::WallTimer Every(Duration period, std::function<void()> call);

  /// Makes `subscriber` listen to this topic; one that does already goes on. Empty: to none.
  template <class Message>
  void Subscribe(ros::Subscriber& subscriber, const std::string& topic, int queue,
                 std::function<void(const Message&)> on_message) {
    if (subscriber.getTopic() == topic) return;
    subscriber.shutdown();
    subscriber = ros::Subscriber();
    if (topic.empty()) return;
    subscriber = handle_.subscribe<Message>(
        topic, static_cast<std::uint32_t>(queue),
        [call = std::move(on_message)](const typename Message::ConstPtr& message) {
          call(*message);
        });
  }

  /// To /monitoring/reports. A finding without host is about the host of its node, else this one.
  void Publish(std::vector<Finding> findings);

 private:
  void OnProcesses(const ProcessTable& processes);

  const MonitorStart& start_;
  std::function<void(const WatchList&)> on_list_;
  ros::NodeHandle handle_;
  ProcessTable processes_;
  std::string configuration_;
  ros::Publisher reports_;
  ros::Subscriber subscriber_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_MONITOR_NODE_H_
