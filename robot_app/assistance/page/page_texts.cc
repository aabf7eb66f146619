#include "robot_app/assistance/page/page_texts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "robot_app/common/ros_support.h"

namespace coppice::robot::assistance {
namespace {

using coppice_msgs::HealthEntry;
using coppice_msgs::ProcessState;
using nlohmann::json;

constexpr std::size_t kMostPoints = 200;

std::string Dump(const json& object) {
  return object.dump(-1, ' ', false, json::error_handler_t::replace);
}

const char* LevelName(std::uint8_t level) {
  switch (level) {
    case HealthEntry::OK:
      return "ok";
    case HealthEntry::WARN:
      return "warn";
    case HealthEntry::ERROR:
      return "error";
    default:
      return "stale";
  }
}

// A silent monitor may hide anything.
int Badness(std::uint8_t level) {
  return level == HealthEntry::ERROR ? 3 : level == HealthEntry::STALE ? 2 : level;
}

const char* StateName(std::uint8_t state) {
  switch (state) {
    case ProcessState::STOPPED:
      return "stopped";
    case ProcessState::STARTING:
      return "starting";
    case ProcessState::READY:
      return "ready";
    case ProcessState::BACKING_OFF:
      return "backing off";
    case ProcessState::GIVEN_UP:
      return "given up";
    default:
      return "unreachable";
  }
}

// In centimetres, which is what a screen can show.
double Rounded(double value) { return std::round(value * 100) / 100; }

template <class Value>
void Append(std::string& bytes, Value value) {
  char raw[sizeof(value)];
  std::memcpy(raw, &value, sizeof(value));
  bytes.append(raw, sizeof(raw));
}

}  // namespace

std::string HealthText(const coppice_msgs::Health& health) {
  std::vector<const HealthEntry*> sorted;
  for (const HealthEntry& entry : health.entries) sorted.push_back(&entry);
  std::stable_sort(sorted.begin(), sorted.end(), [](const HealthEntry* a, const HealthEntry* b) {
    return Badness(a->level) > Badness(b->level);
  });
  json entries = json::array();
  for (const HealthEntry* const entry : sorted) {
    entries.push_back({{"monitor", entry->monitor},
                       {"subject", entry->subject},
                       {"level", LevelName(entry->level)},
                       {"message", entry->message}});
  }
  return Dump({{"type", "health"}, {"entries", entries}});
}

std::string ProcessesText(const coppice_msgs::ProcessStates& states) {
  std::map<std::string, json> groups;
  for (const ProcessState& process : states.processes) {
    json& group = groups[process.group.empty() ? process.name : process.group];
    group.push_back({{"name", process.name},
                     {"state", StateName(process.state)},
                     {"restarts", process.restarts},
                     {"message", process.message}});
  }
  json list = json::array();
  for (const auto& [name, processes] : groups) {
    list.push_back({{"name", name}, {"processes", processes}});
  }
  return Dump({{"type", "processes"},
               {"configuration", states.configuration},
               {"safe_stop", static_cast<bool>(states.safe_stop)},
               {"groups", list}});
}

std::string PlaceText(const std::optional<Pose2D>& pose, const std::vector<Point2D>& scan) {
  json points = json::array();
  const std::size_t step = std::max<std::size_t>(1, (scan.size() + kMostPoints - 1) / kMostPoints);
  for (std::size_t i = 0; i < scan.size(); i += step) {
    points.push_back(Rounded(scan[i].x));
    points.push_back(Rounded(scan[i].y));
  }
  json where;
  if (pose) where = {Rounded(pose->x), Rounded(pose->y), pose->yaw};
  return Dump({{"type", "place"}, {"pose", where}, {"scan", points}});
}

std::string TreesText(const std::vector<TreeText>& trees) {
  json list = json::array();
  for (const TreeText& tree : trees) {
    list.push_back({{"name", tree.name}, {"live", tree.is_live}, {"path", tree.path}});
  }
  return Dump({{"type", "trees"}, {"trees", list}});
}

std::optional<std::string> MapBytes(const nav_msgs::OccupancyGrid& map) {
  const std::uint64_t cells = std::uint64_t{map.info.width} * map.info.height;
  if (cells != map.data.size() || cells == 0 || cells > OccupancyGrid::kMostCells) {
    return std::nullopt;
  }
  if (!(map.info.resolution > 0) || !IsValid(map.info.origin)) return std::nullopt;
  const Pose2D corner = ToPose2D(map.info.origin);
  std::string bytes = {2, 0, 0, 0};
  Append(bytes, static_cast<std::int32_t>(map.info.width));
  Append(bytes, static_cast<std::int32_t>(map.info.height));
  for (const double number : {double{map.info.resolution}, corner.x, corner.y, corner.yaw}) {
    Append(bytes, static_cast<float>(number));
  }
  bytes.append(reinterpret_cast<const char*>(map.data.data()), map.data.size());
  return bytes;
}

}  // namespace coppice::robot::assistance
