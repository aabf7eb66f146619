#include "robot_app/monitoring/system/system_monitor.h"

#include <algorithm>
#include <utility>

#include "robot_app/monitoring/system/system_gauges.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kBitsPerByte = 8;
constexpr double kMega = 1e6;

// A disk or a driver that hangs longer than that is told.
constexpr Duration kLongestLook = std::chrono::seconds(10);

}  // namespace

void SystemMonitor::Watch(const SystemWatch* watch) {
  if (!watch || watch->window != watch_.window) rates_.clear();
  is_on_ = watch != nullptr;
  watch_ = watch ? *watch : SystemWatch();
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

SystemQuestion SystemMonitor::Question(const std::map<std::string, int>& pids) const {
  SystemQuestion question;
  for (const DiskWatch& disk : watched_.disks) question.disks.push_back(disk.path);
  for (const InterfaceWatch& link : watched_.interfaces) question.links.push_back(link.interface);
  for (const ProcessWatch& process : watched_.processes) {
    const auto found = pids.find(process.node);
    if (found != pids.end() && found->second > 0) question.pids.insert(*found);
  }
  return question;
}

void SystemMonitor::OnSample(const SystemSample& sample) {
  const Time now = sample.time;
  last_sample_ = now;
  OnLinksUp(sample.links_up);
  if (sample.cpu) OnCpu(*sample.cpu, now);
  if (sample.temperature) board_.OnValue("cpu", "temperature", *sample.temperature, now);
  if (sample.memory_used) board_.OnValue("memory", "used", *sample.memory_used, now);
  for (const auto& [path, used] : sample.disks) {
    if (used) {
      board_.OnValue("disk", path, *used, now);
    } else {
      board_.OnFailure("disk", path, "no such disk", now);
    }
  }
  for (const InterfaceWatch& watch : watched_.interfaces) {
    const auto found = sample.links.find(watch.interface);
    if (found != sample.links.end()) OnLink(watch, found->second, now);
  }
  for (const auto& [node, process] : sample.processes) OnProcess(node, process, now);
}

void SystemMonitor::OnLinksUp(const std::vector<std::string>& links) {
  if (links == links_) return;
  links_ = links;
  Expand();
}

void SystemMonitor::OnCpu(const CpuTimes& times, Time now) {
  const auto busy = Rate("cpu busy", static_cast<double>(times.busy), now);
  const auto total = Rate("cpu total", static_cast<double>(times.total), now);
  if (busy && total && *total > 0) board_.OnValue("cpu", "load", *busy / *total, now);
}

void SystemMonitor::OnLink(const InterfaceWatch& watch, const LinkSample& link, Time now) {
  const std::string name = watch.interface + " ";
  if (!link.counters) return board_.OnFailure("network", name + "load", "no such interface", now);
  if (link.is_down) return board_.OnFailure("network", name + "load", "the link is down", now);
  const auto received = Rate(name + "received", static_cast<double>(link.counters->received), now);
  const auto sent = Rate(name + "sent", static_cast<double>(link.counters->sent), now);
  if (received && sent) {
    const double bits = std::max(*received, *sent) * kBitsPerByte;
    const double speed = link.speed.value_or(watch.speed);
    board_.OnValue("network", name + "load", bits / (speed * kMega), now);
  }
  const auto errors = Rate(name + "errors", static_cast<double>(link.counters->errors), now);
  if (errors) board_.OnValue("network", name + "errors", *errors, now);
  const auto drops = Rate(name + "drops", static_cast<double>(link.counters->drops), now);
  if (drops) board_.OnValue("network", name + "drops", *drops, now);
}

void SystemMonitor::OnProcess(const std::string& node, const ProcessSample& process, Time now) {
  const std::string name = node + " ";
  const ProcessUsage& usage = process.usage;
  if (const auto cpu = Rate(name + std::to_string(process.pid), usage.cpu_time, now)) {
    board_.OnValue("process", name + "cpu", *cpu, now);
  }
  board_.OnValue("process", name + "memory", usage.memory, now);
  board_.OnValue("process", name + "threads", usage.threads, now);
  if (usage.files) board_.OnValue("process", name + "files", *usage.files, now);
}

// Processes are left out: that they cannot be looked at is no reason to restart them.
void SystemMonitor::TellSilence(Time now) {
  if (!is_on_) return;
  if (!last_sample_) last_sample_ = now;  // the first look has begun
  const Duration silence = now - *last_sample_;
  if (silence <= kLongestLook) return;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(silence).count();
  const std::string why =
      "the system has not answered for " + std::to_string(seconds) + " s: does a disk hang?";
  board_.OnFailure("cpu", "load", why, now);
  board_.OnFailure("memory", "used", why, now);
  for (const DiskWatch& disk : watched_.disks) board_.OnFailure("disk", disk.path, why, now);
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
  TellSilence(now.wall);
  return board_.Report(now.wall, now.ros);
}

}  // namespace coppice::robot::monitoring
