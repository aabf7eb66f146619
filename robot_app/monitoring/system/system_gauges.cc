#include "robot_app/monitoring/system/system_gauges.h"

#include <fnmatch.h>

#include <algorithm>

namespace coppice::robot::monitoring {
namespace {

bool IsPattern(const std::string& name) { return name.find_first_of("*?[") != std::string::npos; }

template <class Watch>
bool IsWatched(const std::vector<Watch>& watches, const std::string& name,
               std::string Watch::*name_of) {
  return std::any_of(watches.begin(), watches.end(),
                     [&](const Watch& watch) { return watch.*name_of == name; });
}

// What is written by name comes first and stays as it is.
std::vector<InterfaceWatch> LinksOf(const std::vector<InterfaceWatch>& watches,
                                    const std::vector<std::string>& links) {
  std::vector<InterfaceWatch> found;
  for (const InterfaceWatch& watch : watches) {
    if (!IsPattern(watch.interface)) found.push_back(watch);
  }
  for (const InterfaceWatch& watch : watches) {
    if (!IsPattern(watch.interface)) continue;
    for (const std::string& link : links) {
      if (fnmatch(watch.interface.c_str(), link.c_str(), 0) != 0) continue;
      if (IsWatched(found, link, &InterfaceWatch::interface)) continue;
      found.push_back(watch);
      found.back().interface = link;
    }
  }
  return found;
}

template <class Watch>
std::vector<Watch> HostsOf(const std::vector<Watch>& watches, const std::vector<Computer>& others) {
  std::vector<Watch> found;
  for (const Watch& watch : watches) {
    if (watch.host != kEveryHost) found.push_back(watch);
  }
  for (const Watch& watch : watches) {
    if (watch.host != kEveryHost) continue;
    for (const Computer& other : others) {
      if (IsWatched(found, other.name, &Watch::host)) continue;
      found.push_back(watch);
      found.back().host = other.name;
      found.back().address = other.address;
    }
  }
  return found;
}

}  // namespace

SystemWatch WithNames(const SystemWatch& watch, const std::vector<std::string>& links,
                      const std::vector<Computer>& others) {
  SystemWatch named = watch;
  named.interfaces = LinksOf(watch.interfaces, links);
  named.clocks = HostsOf(watch.clocks, others);
  named.hosts = HostsOf(watch.hosts, others);
  return named;
}

std::vector<GaugeWatch> GaugesOf(const SystemWatch& watch) {
  std::vector<GaugeWatch> gauges = {
      {"cpu", "load", "", "", watch.cpu_load},
      {"cpu", "temperature", "", "°C", watch.cpu_temperature},
      {"memory", "used", "", "", watch.memory_used},
  };
  for (const DiskWatch& disk : watch.disks) {
    gauges.push_back({"disk", disk.path, "", "", disk.used});
  }
  for (const InterfaceWatch& link : watch.interfaces) {
    gauges.push_back({"network", link.interface + " load", "", "", link.load});
    gauges.push_back({"network", link.interface + " errors", "", "1/s", link.errors});
    gauges.push_back({"network", link.interface + " drops", "", "1/s", link.drops});
  }
  for (const ClockWatch& clock : watch.clocks) {
    gauges.push_back({"clock", clock.host, "", "s", clock.offset});
  }
  for (const ReachWatch& host : watch.hosts) {
    gauges.push_back({"network", "host " + host.host, "", "s", host.delay});
  }
  for (const ProcessWatch& process : watch.processes) {
    gauges.push_back({"process", process.node + " cpu", "", "", process.cpu});
    gauges.push_back({"process", process.node + " memory", "", "MB", process.memory});
    gauges.push_back({"process", process.node + " threads", "", "", process.threads});
    gauges.push_back({"process", process.node + " files", "", "", process.files});
  }
  return gauges;
}

}  // namespace coppice::robot::monitoring
