// Figures with names and labels, as Prometheus reads them (text format 0.0.4).
//
//   MetricTable table;
//   table.Counter("coppice_ticks_total", "ticks of a tree", {{"tree", "monitor"}}, 17);
//   table.Text();     // # HELP coppice_ticks_total ticks of a tree ...
#ifndef COPPICE_ROBOT_APP_METRICS_METRIC_TABLE_H_
#define COPPICE_ROBOT_APP_METRICS_METRIC_TABLE_H_

#include <prometheus/metric_family.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace coppice::robot::metrics {

using Labels = std::vector<std::pair<std::string, std::string>>;

/// How often a duration was at most so long. The last count is of all that were longer.
struct DurationCounts {
  std::vector<double> limits;  ///< s, ascending
  std::vector<std::uint64_t> counts;
  double sum = 0;  ///< s

  explicit DurationCounts(std::vector<double> upper) : limits(std::move(upper)) {
    counts.resize(limits.size() + 1);
  }
  void Add(double seconds);
};

/// Values of one name stand together, whoever adds them. Texts may hold anything.
class MetricTable {
 public:
  /// What only grows; its name ends in _total.
  void Counter(const std::string& name, const char* help, const Labels& labels, double value);
  void Gauge(const std::string& name, const char* help, const Labels& labels, double value);
  void Histogram(const std::string& name, const char* help, const Labels& labels,
                 const DurationCounts& durations);

  std::string Text() const;

 private:
  prometheus::ClientMetric& Add(const std::string& name, const char* help,
                                prometheus::MetricType type, const Labels& labels);

  std::map<std::string, prometheus::MetricFamily> families_;
};

}  // namespace coppice::robot::metrics

#endif  // COPPICE_ROBOT_APP_METRICS_METRIC_TABLE_H_
