#include "bt_core/live/debug/hook_json.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bt_core/base/json_library.h"
#include "bt_core/engine/program.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

template <class T>
struct Name {
  const char* text;
  T value;
};

constexpr Name<HookPosition> kPositions[] = {{"before", HookPosition::kBefore},
                                             {"after", HookPosition::kAfter}};
constexpr Name<HookAction> kActions[] = {
    {"stop", HookAction::kStop}, {"replace", HookAction::kReplace}, {"delay", HookAction::kDelay}};
constexpr Name<Status> kStatuses[] = {{"RUNNING", Status::kRunning},
                                      {"SUCCESS", Status::kSuccess},
                                      {"FAILURE", Status::kFailure},
                                      {"SKIPPED", Status::kSkipped}};
constexpr Name<DebugStop::Where> kPlaces[] = {{"between_ticks", DebugStop::Where::kBetweenTicks},
                                              {"before", DebugStop::Where::kBefore},
                                              {"after", DebugStop::Where::kAfter}};

template <class T, std::size_t n>
T Read(const char* what, const std::string& text, const Name<T> (&names)[n]) {
  std::string expected;
  for (const Name<T>& name : names) {
    if (text == name.text) return name.value;
    expected += (expected.empty() ? "\"" : ", \"") + std::string(name.text) + "\"";
  }
  throw std::invalid_argument(std::string(what) + " \"" + text + "\": expected one of " + expected);
}

template <class T, std::size_t n>
const char* Write(T value, const Name<T> (&names)[n]) {
  for (const Name<T>& name : names) {
    if (name.value == value) return name.text;
  }
  return "IDLE";
}

std::uint32_t ReadCount(const Json& json, const char* member, std::uint32_t otherwise) {
  const auto at = json.find(member);
  if (at == json.end()) return otherwise;
  if (!at->is_number_unsigned() || at->get<std::uint64_t>() > UINT32_MAX) {
    throw std::invalid_argument(std::string(member) + ": expected a number from 0 to 4294967295");
  }
  return at->get<std::uint32_t>();
}

Duration ReadDelay(const Json& json) {
  constexpr double kLongest = 86400e3;  // ms: a day
  const double delay = json.at("delay_ms").get<double>();
  if (!(delay > 0 && delay <= kLongest)) {
    throw std::invalid_argument("delay_ms: expected more than 0 and at most a day");
  }
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(delay));
}

void ReadNode(const Json& node, Hook& hook) {
  if (node.is_string() && !node.get_ref<const std::string&>().empty()) {
    hook.path = node.get<std::string>();
  } else if (node.is_number_unsigned() && node.get<std::uint64_t>() < kNoNode) {
    hook.node = NodeIndex(node.get<std::uint32_t>());
  } else {
    throw std::invalid_argument("node: expected a number from 0 on or a path");
  }
}

}  // namespace

Status ReadStatus(const std::string& name) { return Read("status", name, kStatuses); }

Hook ReadHook(const Json& json) {
  Hook hook;
  if (!json.contains("node")) throw std::invalid_argument("node: which one? A number or a path");
  ReadNode(json["node"], hook);
  hook.position = Read("position", json.value("position", "before"), kPositions);
  hook.action = Read("action", json.value("action", "stop"), kActions);
  if (hook.action == HookAction::kReplace) {
    hook.status = ReadStatus(json.at("status").get<std::string>());
  }
  if (hook.action == HookAction::kDelay) hook.delay = ReadDelay(json);
  hook.condition = json.value("condition", "");
  hook.from_hit = ReadCount(json, "from_hit", 1);
  hook.times = ReadCount(json, "times", 0);
  hook.enabled = json.value("enabled", true);
  return hook;
}

Json WriteHook(const HookInfo& info, bool is_mine) {
  const Hook& hook = info.hook;
  Json json = {{"hook", info.id},
               {"mine", is_mine},
               {"position", Write(hook.position, kPositions)},
               {"action", Write(hook.action, kActions)},
               {"from_hit", hook.from_hit},
               {"times", hook.times},
               {"enabled", hook.enabled},
               {"nodes", info.nodes},
               {"hits", info.hits},
               {"acted", info.acted}};
  if (hook.path.empty()) {
    json["node"] = hook.node;
  } else {
    json["node"] = hook.path;
  }
  if (hook.action == HookAction::kReplace) json["status"] = Write(hook.status, kStatuses);
  if (hook.action == HookAction::kDelay) {
    json["delay_ms"] = std::chrono::duration<double, std::milli>(hook.delay).count();
  }
  if (!hook.condition.empty()) json["condition"] = hook.condition;
  if (!info.problem.empty()) json["problem"] = info.problem;
  return json;
}

Json WriteStop(const DebugStop& stop, const Program& program) {
  if (stop.where == DebugStop::Where::kNowhere) return nullptr;
  Json json = {{"where", Write(stop.where, kPlaces)}, {"tick", stop.tick}};
  if (stop.node < program.nodes.size()) {
    json["node"] = stop.node;
    json["path"] = program.Path(stop.node);
  }
  if (stop.result != Status::kIdle) json["result"] = Write(stop.result, kStatuses);
  if (stop.hook != kNoHook) json["hook"] = stop.hook;
  return json;
}

}  // namespace coppice
