#include "robot_app/processes/supervisor_memory.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "bt_core/base/json_library.h"
#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::processes {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::size_t kMostTimes = 1000;

json FromTimes(const std::vector<Time>& times) {
  json list = json::array();
  for (const Time time : times) list.push_back(ToNanoseconds(time));
  return list;
}

Time ToTime(const json& value, Time now) {
  return std::min(TimeFromNanoseconds(value.get<std::int64_t>()), now);
}

std::vector<Time> ToTimes(const json& list, Time now) {
  std::vector<Time> times;
  for (const json& value : list) times.push_back(ToTime(value, now));
  std::sort(times.begin(), times.end());
  if (times.size() > kMostTimes) times.erase(times.begin(), times.end() - kMostTimes);
  return times;
}

json FromGroup(const GroupMemory& group) {
  json value = {{"restarts", FromTimes(group.restarts)},
                {"counting", group.counting},
                {"step", static_cast<int>(group.step)},
                {"closures", group.closures},
                {"given_up", group.given_up}};
  if (group.trouble_since) value["trouble_since"] = ToNanoseconds(*group.trouble_since);
  return value;
}

GroupMemory ToGroup(const json& value, Time now) {
  GroupMemory group;
  group.restarts = ToTimes(value.at("restarts"), now);
  group.counting = value.at("counting").get<std::size_t>();
  const int step = value.at("step").get<int>();
  group.step = static_cast<EscalationStep>(std::clamp(step, 0, 3));
  group.closures = std::max(0, value.at("closures").get<int>());
  group.given_up = value.at("given_up").get<std::string>();
  if (value.contains("trouble_since")) group.trouble_since = ToTime(value["trouble_since"], now);
  return group;
}

SupervisorMemory FromJson(const json& value, Time now) {
  SupervisorMemory memory;
  memory.site = value.value("site", "");
  memory.configuration = value.at("configuration").get<std::string>();
  memory.manual = value.at("manual").get<bool>();
  memory.safe_stop = value.at("safe_stop").get<bool>();
  memory.new_stack = value.at("new_stack").get<bool>();
  memory.clear_stack = value.value("clear_stack", false);
  for (const auto& [name, group] : value.at("groups").items()) {
    memory.groups[name] = ToGroup(group, now);
  }
  for (const auto& [name, restarts] : value.at("restarts").items()) {
    memory.restarts[name] = restarts.get<std::uint32_t>();
  }
  memory.stack_restarts = ToTimes(value.at("stack_restarts"), now);
  memory.stack_counting = value.at("stack_counting").get<std::size_t>();
  return memory;
}

}  // namespace

std::string ToText(const SupervisorMemory& memory) {
  json value = {{"version", kVersion},
                {"site", memory.site},
                {"configuration", memory.configuration},
                {"manual", memory.manual},
                {"safe_stop", memory.safe_stop},
                {"new_stack", memory.new_stack},
                {"clear_stack", memory.clear_stack},
                {"groups", json::object()},
                {"restarts", memory.restarts},
                {"stack_restarts", FromTimes(memory.stack_restarts)},
                {"stack_counting", memory.stack_counting}};
  for (const auto& [name, group] : memory.groups) value["groups"][name] = FromGroup(group);
  return value.dump(1) + "\n";
}

Expected<SupervisorMemory> MemoryFromText(const std::string& text, Time now) {
  try {
    const json value = ParseLimitedJson(text);
    if (value.at("version") == kVersion) return FromJson(value, now);
    return Problem{"is of another version"};
  } catch (const std::exception&) {
    return Problem{"is damaged"};
  }
}

Expected<SupervisorMemory> LoadMemory(const std::string& path, Time now) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return SupervisorMemory{};
  const std::optional<std::string> text = ReadFile(path);
  return text ? MemoryFromText(*text, now) : Problem{"cannot be read"};
}

Outcome SaveMemory(const SupervisorMemory& memory, const std::string& path) {
  Diagnostics diagnostics;
  if (WriteFile(path, ToText(memory), diagnostics, FileReaders::kOwnerOnly)) return {};
  return Problem{diagnostics.ToString()};
}

void KeepMemory(const SupervisorMemory& memory, const std::string& path) {
  const Outcome saved = SaveMemory(memory, path);
  if (!saved) std::cerr << "coppice-supervisor: " << saved.problem() << "\n";
}

}  // namespace coppice::robot::processes
