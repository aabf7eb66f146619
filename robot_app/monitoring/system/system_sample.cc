#include "robot_app/monitoring/system/system_sample.h"

namespace coppice::robot::monitoring {

// What counts first: the rest may let the reader wait.
SystemSample LookAtSystem(const std::string& root, const SystemQuestion& question, Time now) {
  SystemSample sample;
  sample.time = now;
  sample.cpu = ReadCpuTimes(root);
  for (const std::string& link : question.links) {
    sample.links[link].counters = ReadInterface(root, link);
  }
  for (const auto& [node, pid] : question.pids) {
    const auto usage = pid > 0 ? ReadProcessUsage(root, pid) : std::nullopt;
    if (usage) sample.processes[node] = {pid, *usage};
  }
  sample.memory_used = ReadMemoryUsed(root);
  sample.temperature = ReadTemperature(root);
  sample.links_up = ReadLinks(root);
  for (auto& [name, link] : sample.links) {
    link.is_down = IsLinkDown(root, name);
    link.speed = ReadLinkSpeed(root, name);
  }
  for (const std::string& path : question.disks) sample.disks[path] = ReadDiskUsed(path);
  return sample;
}

}  // namespace coppice::robot::monitoring
