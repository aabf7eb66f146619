#include "robot_app/monitoring/system/system_fields.h"

#include "robot_app/monitoring/gauges/band_fields.h"

namespace coppice::robot::monitoring {
namespace {

DiskWatch ReadDisk(YamlFields& fields) {
  DiskWatch watch;
  watch.path = fields.Text("path").text;
  watch.used = ReadBand(fields, "used", AtMost(0.9, 0.97, 1));
  fields.Finish();
  return watch;
}

InterfaceWatch ReadInterface(YamlFields& fields) {
  InterfaceWatch watch;
  watch.interface = fields.Text("interface").text;
  watch.speed = fields.Number("speed", 1000, 0.001, 1e6);
  watch.load = ReadBand(fields, "load", AtMost(0.8, 0.95, 5));
  watch.errors = ReadBand(fields, "errors", AtMost(1, 100, 3));
  watch.drops = ReadBand(fields, "drops", AtMost(10, 1000, 3));
  fields.Finish();
  return watch;
}

// Every host has an address of its own.
std::string ReadAddress(YamlFields& fields, const std::string& host) {
  return host == kEveryHost ? "" : fields.Text("address", host).text;
}

ClockWatch ReadClock(YamlFields& fields) {
  ClockWatch watch;
  watch.host = fields.Text("host").text;
  watch.address = ReadAddress(fields, watch.host);
  watch.must_serve = watch.host != kEveryHost;
  watch.port = fields.Integer("port", watch.port, 1, 65535);
  watch.offset = ReadBand(fields, "offset", {{-0.1, 0.1}, {-1, 1}, 2, Duration::zero(), 0});
  fields.Finish();
  return watch;
}

ReachWatch ReadReach(YamlFields& fields) {
  ReachWatch watch;
  watch.host = fields.Text("host").text;
  watch.address = ReadAddress(fields, watch.host);
  watch.port = fields.Integer("port", watch.port, 1, 65535);
  watch.delay = ReadBand(fields, "delay", AtMost(0.2, 1, 2));
  fields.Finish();
  return watch;
}

ProcessWatch ReadProcess(YamlFields& fields) {
  ProcessWatch watch;
  watch.node = ReadRosName(fields, "node");
  watch.cpu = ReadBand(fields, "cpu", {{std::nullopt, 0.9}, {}, 10, Duration::zero(), 0});
  watch.memory = ReadBand(fields, "memory", AtMost(1000, 4000, 1));
  watch.threads = ReadBand(fields, "threads", AtMost(100, 1000, 1));
  watch.files = ReadBand(fields, "files", AtMost(800, 1000, 1));
  fields.Finish();
  return watch;
}

template <class Watch>
void CheckNames(const YamlFields& fields, const std::vector<Watch>& watches,
                std::string Watch::*name) {
  std::vector<std::string> names;
  for (const Watch& watch : watches) names.push_back(watch.*name);
  CheckUnique(fields, names);
}

void ReadLists(YamlFields& fields, SystemWatch& watch) {
  for (YamlFields& item : fields.Maps("disks")) watch.disks.push_back(ReadDisk(item));
  for (YamlFields& item : fields.Maps("network")) {
    watch.interfaces.push_back(ReadInterface(item));
  }
  for (YamlFields& item : fields.Maps("clocks")) watch.clocks.push_back(ReadClock(item));
  for (YamlFields& item : fields.Maps("hosts")) watch.hosts.push_back(ReadReach(item));
  for (YamlFields& item : fields.Maps("processes")) watch.processes.push_back(ReadProcess(item));
  CheckNames(fields, watch.disks, &DiskWatch::path);
  CheckNames(fields, watch.interfaces, &InterfaceWatch::interface);
  CheckNames(fields, watch.clocks, &ClockWatch::host);
  CheckNames(fields, watch.hosts, &ReachWatch::host);
  CheckNames(fields, watch.processes, &ProcessWatch::node);
}

}  // namespace

SystemWatch ReadSystemWatch(YamlFields& fields) {
  SystemWatch watch;
  watch.host = fields.Text("host", "").text;
  watch.period = fields.Seconds("period", 1, 0.1, 600);
  watch.window = fields.Seconds("window", 5, 0.1, 600);
  watch.ask_period = fields.Seconds("ask_period", 5, 0.1, 3600);
  watch.deadline = fields.Seconds("deadline", 1, 0.01, 60);
  YamlFields cpu = fields.Map("cpu");
  watch.cpu_load = ReadBand(cpu, "load", AtMost(0.9, 0.97, 5));
  watch.cpu_temperature = ReadBand(cpu, "temperature", AtMost(85, 95, 3));
  cpu.Finish();
  YamlFields memory = fields.Map("memory");
  watch.memory_used = ReadBand(memory, "used", AtMost(0.85, 0.95, 3));
  memory.Finish();
  ReadLists(fields, watch);
  fields.Finish();
  return watch;
}

}  // namespace coppice::robot::monitoring
