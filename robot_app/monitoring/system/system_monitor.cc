#include "robot_app/monitoring/system/system_monitor.h"

#include <algorithm>
#include <utility>

#include "robot_app/monitoring/system/proc_files.h"
#include "robot_app/monitoring/system/system_gauges.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kBitsPerByte = 8;
constexpr double kMega = 1e6;

}  // namespace

void SystemMonitor::Watch(const SystemWatch* watch) {
  if (!watch || watch->window != watch_.window) rates_.clear();
  is_on_ = watch != nullptr;
  watch_ = watch ? *watch : SystemWatch();
  links_ = ReadLinks(root_);
  Expand();
}

bool SystemMonitor::OnComputers(const std::vector<Computer>& others) {
  if (others == others_) return false;
  others_ = others;
  Expand();
  return true;
}

void SystemMonitor::Expand() {
  watched_ = WithNames(watch_, links_, others_);
  board_.Watch(is_on_ ? GaugesOf(watched_) : std::vector<GaugeWatch>());
}

std::optional<double> SystemMonitor::Rate(const std::string& counter, double reading, Time now) {
  return rates_.try_emplace(counter, watch_.window).first->second.OnReading(reading, now);
}

void SystemMonitor::Measure(const std::map<std::string, int>& pids, Time now) {
  MeasureCpu(now);
  if (const auto used = ReadMemoryUsed(root_)) board_.OnValue("memory", "used", *used, now);
  for (const DiskWatch& disk : watched_.disks) {
    if (const auto used = ReadDiskUsed(disk.path)) {
      board_.OnValue("disk", disk.path, *used, now);
    } else {
      board_.OnFailure("disk", disk.path, "no such disk", now);
    }
  }
  if (std::vector<std::string> links = ReadLinks(root_); links != links_) {
    links_ = std::move(links);
    Expand();
  }
  for (const InterfaceWatch& link : watched_.interfaces) MeasureNetwork(link, now);
  for (const ProcessWatch& process : watched_.processes) {
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
  if (IsLinkDown(root_, link.interface)) {
    board_.OnFailure("network", name + "load", "the link is down", now);
    return;
  }
  const auto received = Rate(name + "received", static_cast<double>(counters->received), now);
  const auto sent = Rate(name + "sent", static_cast<double>(counters->sent), now);
  if (received && sent) {
    const double bits = std::max(*received, *sent) * kBitsPerByte;
    const double speed = ReadLinkSpeed(root_, link.interface).value_or(link.speed);
    board_.OnValue("network", name + "load", bits / (speed * kMega), now);
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

void SystemMonitor::OnClocks(const std::vector<Expected<ClockReading>>& readings, Time now) {
  for (std::size_t i = 0; i < std::min(readings.size(), watched_.clocks.size()); ++i) {
    const ClockWatch& clock = watched_.clocks[i];
    const std::string& host = clock.host;
    if (readings[i]) {
      serving_.insert(host);
      board_.OnValue("clock", host, readings[i]->offset, now);
    } else if (clock.must_serve || serving_.count(host) > 0) {
      board_.OnFailure("clock", host, readings[i].problem(), now);
    }
  }
}

void SystemMonitor::OnHosts(const std::vector<ReachDelay>& results, Time now) {
  for (std::size_t i = 0; i < std::min(results.size(), watched_.hosts.size()); ++i) {
    const std::string subject = "host " + watched_.hosts[i].host;
    if (results[i]) {
      board_.OnValue("network", subject, *results[i], now);
    } else {
      board_.OnFailure("network", subject, results[i].problem(), now);
    }
  }
}

std::vector<Finding> SystemMonitor::Report(const ProcessTable&, const Times& now) {
  return board_.Report(now.wall, now.ros);
}

}  // namespace coppice::robot::monitoring
