#include "robot_app/monitoring/system/system_monitor.h"

#include <algorithm>

#include "robot_app/monitoring/system/proc_files.h"
#include "robot_app/monitoring/system/system_fields.h"

namespace coppice::robot {
namespace {

constexpr double kBitsPerByte = 8;
constexpr double kMega = 1e6;

}  // namespace

void SystemMonitor::Watch(const SystemWatch* watch) {
  board_.Watch(watch ? GaugesOf(*watch) : std::vector<GaugeWatch>());
  if (!watch || watch->window != watch_.window) rates_.clear();
  watch_ = watch ? *watch : SystemWatch();
}

std::optional<double> SystemMonitor::Rate(const std::string& counter, double reading, Time now) {
  return rates_.try_emplace(counter, watch_.window).first->second.OnReading(reading, now);
}

void SystemMonitor::Measure(const std::map<std::string, int>& pids, Time now) {
  MeasureCpu(now);
  if (const auto used = ReadMemoryUsed(root_)) board_.OnValue("memory", "used", *used, now);
  for (const DiskWatch& disk : watch_.disks) {
    if (const auto used = ReadDiskUsed(disk.path)) {
      board_.OnValue("disk", disk.path, *used, now);
    } else {
      board_.OnFailure("disk", disk.path, "no such disk", now);
    }
  }
  for (const InterfaceWatch& link : watch_.interfaces) MeasureNetwork(link, now);
  for (const ProcessWatch& process : watch_.processes) {
    const auto found = pids.find(process.node);
    if (found != pids.end() && found->second > 0) MeasureProcess(process, found->second, now);
  }
}

void SystemMonitor::MeasureCpu(Time now) {
  if (const auto degrees = ReadTemperature(root_)) {
    board_.OnValue("cpu", "temperature", *degrees, now);
  }
  const auto times = ReadCpuTimes(root_);
  if (!times) return;
  const auto busy = Rate("cpu busy", static_cast<double>(times->busy), now);
  const auto total = Rate("cpu total", static_cast<double>(times->total), now);
  if (busy && total && *total > 0) board_.OnValue("cpu", "load", *busy / *total, now);
}

void SystemMonitor::MeasureNetwork(const InterfaceWatch& link, Time now) {
  const std::string name = link.interface + " ";
  const auto counters = ReadInterface(root_, link.interface);
  if (!counters) {
    board_.OnFailure("network", name + "load", "no such interface", now);
    return;
  }
  const auto received = Rate(name + "received", static_cast<double>(counters->received), now);
  const auto sent = Rate(name + "sent", static_cast<double>(counters->sent), now);
  if (received && sent) {
    const double bits = std::max(*received, *sent) * kBitsPerByte;
    board_.OnValue("network", name + "load", bits / (link.speed * kMega), now);
  }
  const auto errors = Rate(name + "errors", static_cast<double>(counters->errors), now);
  if (errors) board_.OnValue("network", name + "errors", *errors, now);
  const auto drops = Rate(name + "drops", static_cast<double>(counters->drops), now);
  if (drops) board_.OnValue("network", name + "drops", *drops, now);
}

void SystemMonitor::MeasureProcess(const ProcessWatch& process, int pid, Time now) {
  const auto usage = ReadProcessUsage(root_, pid);
  if (!usage) return;
  const std::string name = process.node + " ";
  if (const auto cpu = Rate(name + std::to_string(pid), usage->cpu_time, now)) {
    board_.OnValue("process", name + "cpu", *cpu, now);
  }
  board_.OnValue("process", name + "memory", usage->memory, now);
  board_.OnValue("process", name + "threads", usage->threads, now);
  if (usage->files) board_.OnValue("process", name + "files", *usage->files, now);
}

void SystemMonitor::OnClocks(const std::vector<ClockReading>& readings, Time now) {
  for (std::size_t i = 0; i < std::min(readings.size(), watch_.clocks.size()); ++i) {
    const std::string& host = watch_.clocks[i].host;
    if (readings[i].ok) {
      board_.OnValue("clock", host, readings[i].offset, now);
    } else {
      board_.OnFailure("clock", host, readings[i].error, now);
    }
  }
}

void SystemMonitor::OnHosts(const std::vector<ReachResult>& results, Time now) {
  for (std::size_t i = 0; i < std::min(results.size(), watch_.hosts.size()); ++i) {
    const std::string subject = "host " + watch_.hosts[i].host;
    if (results[i].ok) {
      board_.OnValue("network", subject, results[i].delay, now);
    } else {
      board_.OnFailure("network", subject, results[i].error, now);
    }
  }
}

std::vector<Finding> SystemMonitor::Report(const Times& now) {
  return board_.Report(now.wall, now.ros);
}

}  // namespace coppice::robot
