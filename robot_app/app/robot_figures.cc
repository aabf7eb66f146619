#include "robot_app/app/robot_figures.h"

#include <stdexcept>

#include "robot_app/metrics/metrics_feed.h"

namespace coppice::robot {

RobotFigures::RobotFigures(ros::NodeHandle& node,
                           const std::optional<metrics::MetricsPageOptions>& page) {
  if (!page) return;
  try {
    page_.emplace(*page, [this] { return Text(); });
    subscribers_ = metrics::SubscribeMetrics(node, robot_);
  } catch (const std::runtime_error& error) {
    trouble_ = error.what();
  }
}

std::string RobotFigures::Text() const {
  metrics::MetricTable table;
  robot_.Collect(table);
  application_.Collect(table);
  monitor_.Collect(table);
  return table.Text();
}

}  // namespace coppice::robot
