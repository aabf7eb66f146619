#include "robot_app/monitoring/monitor_program.h"

#include <iterator>
#include <utility>

namespace coppice::robot::monitoring {

MonitorProgram::MonitorProgram(const MonitorStart& start, std::vector<Monitor*> monitors,
                               std::mutex* guard)
    : start_(start),
      monitors_(std::move(monitors)),
      guard_(guard),
      node_(start, [this](const WatchList& list) { Watch(list); }) {}

void MonitorProgram::OnList(std::function<void(const WatchList&)> subscribe) {
  subscribe_ = std::move(subscribe);
  subscribe_(node_.list());
}

std::unique_lock<std::mutex> MonitorProgram::Guard() const {
  return guard_ ? std::unique_lock<std::mutex>(*guard_) : std::unique_lock<std::mutex>();
}

void MonitorProgram::Watch(const WatchList& list) {
  {
    const auto guard = Guard();
    for (Monitor* monitor : monitors_) monitor->Watch(list, MonitorNode::Now());
  }
  if (subscribe_) subscribe_(list);  // never under the guard
}

void MonitorProgram::ReportRegularly(std::function<void(const Times&)> look) {
  timer_ = node_.Every(start_.config.report_period, [this, look = std::move(look)] {
    const Times now = MonitorNode::Now();
    look(now);
    Report(now);
  });
}

void MonitorProgram::Report(const Times& now) {
  std::vector<Finding> findings;
  {
    const auto guard = Guard();
    for (Monitor* monitor : monitors_) {
      std::vector<Finding> more = monitor->Report(node_.processes(), now);
      findings.insert(findings.end(), std::make_move_iterator(more.begin()),
                      std::make_move_iterator(more.end()));
    }
  }
  node_.Publish(std::move(findings));
}

}  // namespace coppice::robot::monitoring
