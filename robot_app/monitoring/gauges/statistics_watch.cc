#include "robot_app/monitoring/gauges/statistics_watch.h"

#include <algorithm>
#include <map>

namespace coppice::robot::monitoring {

void StatisticsWatch::Reset() {
  judge_.Reset();
  since_.reset();
  links_.clear();
}

void StatisticsWatch::Continue(const StatisticsWatch& other) {
  since_ = other.since_;
  links_ = other.links_;
  if (watch_.band == other.watch_.band) judge_ = other.judge_;
}

void StatisticsWatch::OnStatistics(const SubscriberStatistics& statistics, Time now) {
  const auto known = std::find_if(links_.begin(), links_.end(), [&statistics](const Link& link) {
    return link.statistics.publisher == statistics.publisher &&
           link.statistics.subscriber == statistics.subscriber;
  });
  if (known == links_.end()) {
    links_.push_back({statistics, now});
  } else {
    *known = {statistics, now};
  }
}

double StatisticsWatch::Rate() const {
  std::map<std::string, double> received;
  double most = 0;
  for (const Link& link : links_) {
    double& rate = received[link.statistics.subscriber];
    rate += link.statistics.rate;
    most = std::max(most, rate);
  }
  return most;
}

Finding StatisticsWatch::Assess(Time now) {
  if (since_ && now < *since_) Reset();
  if (!since_) since_ = now;
  const Duration staleness = watch_.band.staleness;
  Time newest = *since_;
  for (const Link& link : links_) newest = std::max(newest, link.heard_at);
  links_.erase(std::remove_if(links_.begin(), links_.end(),
                              [&](const Link& link) {
                                return staleness > Duration::zero() &&
                                       now - link.heard_at > staleness;
                              }),
               links_.end());

  Finding finding{"topic", watch_.topic, watch_.node, leaves::HealthLevel::kOk,
                  Rate(),  "Hz",         "",          now};
  if (!links_.empty()) {
    judge_.OnValue(finding.value, now);
    const Assessment assessment = judge_.Assess(now);
    finding.level = assessment.level;
    finding.message = assessment.message;
  } else if (staleness > Duration::zero() && now - newest > staleness) {
    finding.level = leaves::HealthLevel::kError;
    finding.message = "no subscriber reports it on /statistics";
  } else {
    finding.message = "measuring";
  }
  return finding;
}

}  // namespace coppice::robot::monitoring
