#include "robot_app/metrics/robot_metrics.h"

#include <algorithm>
#include <cmath>

#include "bt_core/model/utf8.h"

namespace coppice::robot::metrics {
namespace {

// Of the store, by the names on /store/status.
struct StoreFigure {
  const char* key;
  const char* name;
  const char* help;
};
constexpr StoreFigure kWaiting[] = {
    {"documents", "coppice_store_waiting_messages", "messages that wait for the server"},
    {"bytes", "coppice_store_spool_bytes", "of the spool on the disk"},
    {"oldest", "coppice_store_oldest_seconds", "age of the oldest message that waits"},
    {"refused", "coppice_store_refused_messages", "messages that the server has refused"}};
constexpr StoreFigure kCounted[] = {
    {"stored", "coppice_store_stored_messages_total", "messages that the spool has accepted"},
    {"sent", "coppice_store_sent_messages_total", "messages that the server has committed"},
    {"lost", "coppice_store_lost_messages_total", "messages that were given up"}};

std::string Name(const std::string& text) { return PlainText(text, RobotMetrics::kLongestName); }

// Null if there are too many others.
template <class Value>
Value* Among(std::map<std::pair<std::string, std::string>, Value>& all,
             std::pair<std::string, std::string> key) {
  const auto found = all.find(key);
  if (found != all.end()) return &found->second;
  if (all.size() >= RobotMetrics::kMostOfAKind) return nullptr;
  return &all[std::move(key)];
}

}  // namespace

void RobotMetrics::SetHealth(const std::vector<leaves::HealthEntry>& entries) {
  std::map<std::pair<std::string, std::string>, leaves::HealthLevel> worst;  // of several hosts
  for (const leaves::HealthEntry& entry : entries) {
    if (leaves::HealthLevel* const level =
            Among(worst, {Name(entry.monitor), Name(entry.subject)})) {
      *level = std::max(*level, entry.level);
    }
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  worst_ = std::move(worst);
}

void RobotMetrics::SetBattery(const leaves::BatteryReading& battery) {
  const std::lock_guard<std::mutex> lock(mutex_);
  battery_ = battery;
}

void RobotMetrics::SetProcesses(ProcessesFigures figures) {
  if (figures.processes.size() > kMostOfAKind) figures.processes.resize(kMostOfAKind);
  figures.configuration = Name(figures.configuration);
  for (ProcessFigures& process : figures.processes) process.name = Name(process.name);
  const std::lock_guard<std::mutex> lock(mutex_);
  processes_ = std::move(figures);
}

void RobotMetrics::SetOpenRequests(std::size_t open) {
  const std::lock_guard<std::mutex> lock(mutex_);
  open_requests_ = open;
}

void RobotMetrics::SetStore(const std::map<std::string, double>& store) {
  const std::lock_guard<std::mutex> lock(mutex_);
  store_.clear();
  const auto take = [&](const StoreFigure& figure) {
    const auto found = store.find(figure.key);
    if (found != store.end() && std::isfinite(found->second)) store_.insert(*found);
  };
  std::for_each(std::begin(kWaiting), std::end(kWaiting), take);
  std::for_each(std::begin(kCounted), std::end(kCounted), take);
}

void RobotMetrics::CountRecovery(const std::string& recovery, const std::string& phase) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::uint64_t* const count = Among(recoveries_, {Name(recovery), phase})) ++*count;
}

void RobotMetrics::Collect(MetricTable& table) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  CollectHealth(table);
  CollectBattery(table);
  CollectProcesses(table);
  CollectStore(table);
  for (const auto& [key, count] : recoveries_) {
    table.Counter("coppice_recoveries_total", "recoveries, by what came of them",
                  {{"recovery", key.first}, {"phase", key.second}}, static_cast<double>(count));
  }
  if (open_requests_) {
    table.Gauge("coppice_open_requests", "questions to human supervisors", {},
                static_cast<double>(*open_requests_));
  }
}

void RobotMetrics::CollectHealth(MetricTable& table) const {
  for (const auto& [key, level] : worst_) {
    table.Gauge("coppice_health_level", "0 OK, 1 WARN, 2 ERROR, 3 STALE",
                {{"monitor", key.first}, {"subject", key.second}}, static_cast<double>(level));
  }
}

void RobotMetrics::CollectBattery(MetricTable& table) const {
  if (!battery_) return;
  const auto measured = [&](const char* name, const char* help, double value) {
    if (std::isfinite(value)) table.Gauge(name, help, {}, value);
  };
  measured("coppice_battery_charge_ratio", "state of charge, 0..1", battery_->level);
  measured("coppice_battery_volts", "at the terminals", battery_->voltage);
  measured("coppice_battery_amperes", "into the battery", battery_->current);
  const std::optional<bool> docked = leaves::StandsOnStation(*battery_);
  if (docked) table.Gauge("coppice_docked", "1: stands on its station", {}, *docked ? 1 : 0);
}

void RobotMetrics::CollectProcesses(MetricTable& table) const {
  if (!processes_) return;
  table.Gauge("coppice_configuration", "1: the one in force",
              {{"configuration", processes_->configuration}}, 1);
  table.Gauge("coppice_safe_stop", "1: stopped until a person resets it", {},
              processes_->safe_stop ? 1 : 0);
  for (const ProcessFigures& process : processes_->processes) {
    table.Gauge("coppice_process_state",
                "0 stopped, 1 starting, 2 ready, 3 backing off, 4 given up, 5 unreachable",
                {{"process", process.name}}, process.state);
    table.Counter("coppice_process_restarts_total", "ever", {{"process", process.name}},
                  process.restarts);
  }
}

void RobotMetrics::CollectStore(MetricTable& table) const {
  const auto find = [this](const char* key) -> const double* {
    const auto found = store_.find(key);
    return found == store_.end() ? nullptr : &found->second;
  };
  for (const StoreFigure& figure : kWaiting) {
    if (const double* value = find(figure.key)) table.Gauge(figure.name, figure.help, {}, *value);
  }
  for (const StoreFigure& figure : kCounted) {
    if (const double* value = find(figure.key)) table.Counter(figure.name, figure.help, {}, *value);
  }
}

}  // namespace coppice::robot::metrics
