// What Prometheus reads of this robot: its trees, its health, and the page that tells them.
#ifndef COPPICE_ROBOT_APP_APP_ROBOT_FIGURES_H_
#define COPPICE_ROBOT_APP_APP_ROBOT_FIGURES_H_

#include <ros/node_handle.h>

#include <optional>
#include <string>
#include <vector>

#include "robot_app/metrics/metrics_page.h"
#include "robot_app/metrics/robot_metrics.h"
#include "robot_app/metrics/tree_metrics.h"

namespace coppice::robot {

class RobotFigures {
 public:
  /// Without a page nothing is heard. A robot runs also when its page cannot be served: see
  /// trouble.
  RobotFigures(ros::NodeHandle& node, const std::optional<metrics::MetricsPageOptions>& page);

  /// To be added to the event streams of the trees; null without a page.
  EventListener* application() { return page_ ? &application_ : nullptr; }
  EventListener* monitor() { return page_ ? &monitor_ : nullptr; }

  /// Why there is no page, though there is to be one, or empty.
  const std::string& trouble() const { return trouble_; }

 private:
  std::string Text() const;

  metrics::RobotMetrics robot_;
  metrics::TreeMetrics application_{"application"};
  metrics::TreeMetrics monitor_{"monitor"};
  std::vector<ros::Subscriber> subscribers_;
  std::string trouble_;
  std::optional<metrics::MetricsPage> page_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_ROBOT_FIGURES_H_
