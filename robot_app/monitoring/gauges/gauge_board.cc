#include "robot_app/monitoring/gauges/gauge_board.h"

#include <limits>
#include <utility>

namespace coppice::robot::monitoring {

void GaugeBoard::Watch(const std::vector<GaugeWatch>& gauges) {
  std::vector<Gauge> watched;
  for (const GaugeWatch& watch : gauges) {
    const Gauge* known = Find(watch.monitor, watch.subject);
    const bool same = known && known->watch.band == watch.band && known->watch.unit == watch.unit;
    watched.push_back({watch, same ? known->judge : Judge(watch.band, watch.unit)});
  }
  gauges_ = std::move(watched);
}

GaugeBoard::Gauge* GaugeBoard::Find(const std::string& monitor, const std::string& subject) {
  for (Gauge& gauge : gauges_) {
    if (gauge.watch.subject == subject && gauge.watch.monitor == monitor) return &gauge;
  }
  return nullptr;
}

void GaugeBoard::OnValue(const std::string& monitor, const std::string& subject, double value,
                         Time now) {
  if (Gauge* gauge = Find(monitor, subject)) gauge->judge.OnValue(value, now);
}

void GaugeBoard::OnFailure(const std::string& monitor, const std::string& subject,
                           const std::string& why, Time now) {
  if (Gauge* gauge = Find(monitor, subject)) gauge->judge.OnFailure(why, now);
}

void GaugeBoard::Reset() {
  for (Gauge& gauge : gauges_) gauge.judge.Reset();
}

std::vector<Finding> GaugeBoard::Report(Time now, Time stamp) {
  std::vector<Finding> findings;
  for (Gauge& gauge : gauges_) {
    const GaugeWatch& watch = gauge.watch;
    Assessment assessment = gauge.judge.Assess(now);
    const double value = gauge.judge.value().value_or(std::numeric_limits<double>::quiet_NaN());
    findings.push_back({watch.monitor, watch.subject, watch.node, assessment.level, value,
                        watch.unit, std::move(assessment.message), stamp, ""});
  }
  return findings;
}

}  // namespace coppice::robot::monitoring
