#include "robot_app/monitoring/system/proc_files.h"

#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace coppice::robot::monitoring {
namespace {

namespace fs = std::filesystem;

constexpr double kMegabyte = 1e6;

// Sensors give thousandths of a degree; what is out of this is no temperature of a computer.
constexpr double kColdest = -50, kHottest = 200;

void ReadSensor(const fs::path& file, std::optional<double>& hottest) {
  double thousandths = 0;
  if (!(std::ifstream(file) >> thousandths)) return;
  const double degrees = thousandths / 1000;
  if (degrees < kColdest || degrees > kHottest) return;
  hottest = std::max(hottest.value_or(degrees), degrees);
}

bool IsSensor(const std::string& file) {
  const std::string begin = "temp", end = "_input";
  return file.rfind(begin, 0) == 0 && file.size() > end.size() &&
         file.compare(file.size() - end.size(), end.size(), end) == 0;
}

std::optional<int> CountFiles(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator files(folder, error);
  if (error) return std::nullopt;
  return static_cast<int>(std::distance(begin(files), end(files)));
}

}  // namespace

std::optional<CpuTimes> ReadCpuTimes(const std::string& root) {
  // cpu user nice system idle iowait irq softirq steal ...; guests are part of user and nice.
  enum { kUser, kNice, kSystem, kIdle, kIoWait, kIrq, kSoftIrq, kSteal, kColumns };
  std::ifstream file(root + "/proc/stat");
  std::string word;
  std::uint64_t columns[kColumns] = {};
  if (!(file >> word) || word != "cpu") return std::nullopt;
  CpuTimes times;
  for (std::uint64_t& column : columns) {
    if (!(file >> column)) return std::nullopt;
    times.total += column;
  }
  times.busy = times.total - columns[kIdle] - columns[kIoWait];
  return times;
}

std::optional<double> ReadTemperature(const std::string& root) {
  std::optional<double> hottest;
  std::error_code error;
  for (const auto& zone : fs::directory_iterator(root + "/sys/class/thermal", error)) {
    if (zone.path().filename().string().rfind("thermal_zone", 0) != 0) continue;
    ReadSensor(zone.path() / "temp", hottest);
  }
  for (const auto& chip : fs::directory_iterator(root + "/sys/class/hwmon", error)) {
    for (const auto& file : fs::directory_iterator(chip.path(), error)) {
      if (IsSensor(file.path().filename())) ReadSensor(file.path(), hottest);
    }
  }
  return hottest;
}

std::optional<double> ReadMemoryUsed(const std::string& root) {
  std::ifstream file(root + "/proc/meminfo");
  std::optional<double> total, available;
  std::string line;
  while (std::getline(file, line) && !(total && available)) {
    std::istringstream words(line);
    std::string name;
    double kilobytes = 0;
    if (!(words >> name >> kilobytes)) continue;
    if (name == "MemTotal:") total = kilobytes;
    if (name == "MemAvailable:") available = kilobytes;
  }
  if (!total || !available || *total <= 0) return std::nullopt;
  return std::clamp(1 - *available / *total, 0.0, 1.0);
}

std::optional<InterfaceCounters> ReadInterface(const std::string& root, const std::string& name) {
  // name: bytes packets errs drop fifo frame compressed multicast, the same for what was sent
  enum { kBytes, kPackets, kErrors, kDrops, kSent = 8, kColumns = 16 };
  std::ifstream file(root + "/proc/net/dev");
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t colon = line.find(':');
    const std::size_t begin = line.find_first_not_of(' ');
    if (colon == std::string::npos || line.substr(begin, colon - begin) != name) continue;
    std::istringstream words(line.substr(colon + 1));
    std::uint64_t columns[kColumns] = {};
    for (std::uint64_t& column : columns) {
      if (!(words >> column)) return std::nullopt;
    }
    return InterfaceCounters{columns[kBytes], columns[kSent + kBytes],
                             columns[kErrors] + columns[kSent + kErrors],
                             columns[kDrops] + columns[kSent + kDrops]};
  }
  return std::nullopt;
}

std::vector<std::string> ReadLinks(const std::string& root) {
  std::ifstream file(root + "/proc/net/dev");
  std::vector<std::string> links;
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t begin = line.find_first_not_of(' ');
    const std::string name = line.substr(begin, colon - begin);
    if (name != "lo" && !IsLinkDown(root, name)) links.push_back(name);
  }
  return links;
}

bool IsLinkDown(const std::string& root, const std::string& name) {
  std::string state;
  std::ifstream(root + "/sys/class/net/" + name + "/operstate") >> state;
  return state == "down" || state == "lowerlayerdown";
}

std::optional<double> ReadLinkSpeed(const std::string& root, const std::string& name) {
  double speed = 0;
  std::ifstream(root + "/sys/class/net/" + name + "/speed") >> speed;
  return speed > 0 ? std::optional(speed) : std::nullopt;  // -1: not known
}

std::optional<ProcessUsage> ReadProcessUsage(const std::string& root, int pid) {
  const std::string folder = root + "/proc/" + std::to_string(pid);
  std::ifstream file(folder + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  // "pid (name) state ...": the name may contain anything, blanks and brackets too.
  const std::size_t bracket = text.rfind(')');
  if (bracket == std::string::npos) return std::nullopt;
  std::istringstream words(text.substr(bracket + 1));
  const std::vector<std::string> fields{std::istream_iterator<std::string>(words), {}};
  // Counted from the state; proc(5) counts it as field 3.
  enum { kState, kUserTime = 11, kSystemTime, kThreads = 17, kResident = 21, kFields };
  if (fields.size() < kFields || fields[kState] == "Z") return std::nullopt;
  const auto number = [&fields](int field) { return std::strtod(fields[field].c_str(), nullptr); };
  ProcessUsage usage;
  usage.cpu_time =
      (number(kUserTime) + number(kSystemTime)) / static_cast<double>(sysconf(_SC_CLK_TCK));
  usage.threads = static_cast<int>(number(kThreads));
  usage.memory = number(kResident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMegabyte;
  usage.files = CountFiles(folder + "/fd");
  return usage;
}

std::optional<double> ReadDiskUsed(const std::string& path) {
  struct statvfs disk {};
  if (statvfs(path.c_str(), &disk) != 0 || disk.f_blocks == 0) return std::nullopt;
  // As df: what is reserved for root is neither used nor free.
  const auto used = static_cast<double>(disk.f_blocks - disk.f_bfree);
  return used / (used + static_cast<double>(disk.f_bavail));
}

}  // namespace coppice::robot::monitoring
