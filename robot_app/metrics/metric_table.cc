#include "robot_app/metrics/metric_table.h"

#include <prometheus/text_serializer.h>

#include <algorithm>
#include <limits>

namespace coppice::robot::metrics {

using prometheus::ClientMetric;
using prometheus::MetricType;

void DurationCounts::Add(double seconds) {
  const auto bucket = std::lower_bound(limits.begin(), limits.end(), seconds) - limits.begin();
  ++counts[static_cast<std::size_t>(bucket)];
  sum += seconds;
}

ClientMetric& MetricTable::Add(const std::string& name, const char* help, MetricType type,
                               const Labels& labels) {
  prometheus::MetricFamily& family = families_[name];
  family.name = name;
  family.help = help;
  family.type = type;
  ClientMetric& metric = family.metric.emplace_back();
  for (const auto& [key, value] : labels) metric.label.push_back({key, value});
  return metric;
}

void MetricTable::Counter(const std::string& name, const char* help, const Labels& labels,
                          double value) {
  Add(name, help, MetricType::Counter, labels).counter.value = value;
}

void MetricTable::Gauge(const std::string& name, const char* help, const Labels& labels,
                        double value) {
  Add(name, help, MetricType::Gauge, labels).gauge.value = value;
}

void MetricTable::Histogram(const std::string& name, const char* help, const Labels& labels,
                            const DurationCounts& durations) {
  ClientMetric::Histogram& histogram = Add(name, help, MetricType::Histogram, labels).histogram;
  for (std::size_t i = 0; i < durations.counts.size(); ++i) {
    histogram.sample_count += durations.counts[i];
    const bool is_last = i == durations.limits.size();
    histogram.bucket.push_back(
        {histogram.sample_count,
         is_last ? std::numeric_limits<double>::infinity() : durations.limits[i]});
  }
  histogram.sample_sum = durations.sum;
}

std::string MetricTable::Text() const {
  std::vector<prometheus::MetricFamily> families;
  for (const auto& [name, family] : families_) families.push_back(family);
  return prometheus::TextSerializer().Serialize(families);
}

}  // namespace coppice::robot::metrics
