#include "bt_core/live/groot2/groot2_hooks.h"

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "bt_core/base/json_library.h"
#include "bt_core/live/groot2/groot2_protocol.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

// What a node returns instead of its own status; everything but these two lets it run.
std::optional<Status> ForcedStatus(const std::string& name) {
  if (name == "SUCCESS") return Status::kSuccess;
  if (name == "FAILURE") return Status::kFailure;
  return std::nullopt;
}

HookPosition ReadPosition(const Json& json) {
  return json.at("position").get<int>() == 0 ? HookPosition::kBefore : HookPosition::kAfter;
}

}  // namespace

Outcome Groot2Hooks::Insert(std::string_view json, std::size_t nodes) {
  const Json parsed = ParseLimitedJson(json);
  std::vector<Json> list = {parsed};
  if (parsed.is_array()) list.assign(parsed.begin(), parsed.end());
  std::vector<Groot2Hook> hooks;
  for (const Json& item : list) {
    Groot2Hook hook;
    hook.enabled = item.at("enabled").get<bool>();
    hook.uid = item.at("uid").get<std::uint16_t>();
    hook.mode = item.at("mode").get<int>() == 0 ? Mode::kBreakpoint : Mode::kReplace;
    hook.once = item.at("once").get<bool>();
    hook.desired_status = item.at("desired_status").get<std::string>();
    hook.position = ReadPosition(item);
    if (hook.uid >= 1 && hook.uid <= nodes) hooks.push_back(std::move(hook));
  }
  for (Groot2Hook& hook : hooks) {
    if (Outcome inserted = InsertOne(std::move(hook)); !inserted) return inserted;
  }
  return {};
}

Outcome Groot2Hooks::InsertOne(Groot2Hook hook) {
  ForgetFinished();
  const Place place(hook.uid, hook.position);
  const auto old = hooks_.find(place);
  const Hook translated = Translate(hook);
  const Expected<HookAnswer> answer = old == hooks_.end()
                                          ? debugger_.Add(translated, owner_)
                                          : debugger_.Change(old->second.id, translated);
  if (!answer) return Problem{answer.problem()};
  hook.id = answer->id;
  hooks_[place] = std::move(hook);
  return {};
}

Hook Groot2Hooks::Translate(const Groot2Hook& hook) {
  Hook result;
  result.node = NodeIndex(hook.uid - 1u);
  result.position = hook.position;
  result.times = hook.once ? 1 : 0;
  result.enabled = hook.enabled;
  if (hook.mode == Mode::kBreakpoint) return result;
  result.action = HookAction::kReplace;
  const std::optional<Status> status = ForcedStatus(hook.desired_status);
  result.status = status.value_or(Status::kSuccess);
  result.enabled = hook.enabled && status.has_value();
  return result;
}

Outcome Groot2Hooks::Remove(std::string_view json) {
  const Json parsed = ParseLimitedJson(json);
  const auto uid = parsed.at("uid").get<std::uint16_t>();
  const HookPosition position = ReadPosition(parsed);
  ForgetFinished();
  const auto hook = hooks_.find({uid, position});
  if (hook == hooks_.end()) return Problem{groot2::kNoSuchNode};
  debugger_.Remove(hook->second.id);
  hooks_.erase(hook);
  return {};
}

Outcome Groot2Hooks::Unlock(std::string_view json) {
  const Json parsed = ParseLimitedJson(json);
  const auto uid = parsed.at("uid").get<std::uint16_t>();
  const auto status = ForcedStatus(parsed.at("desired_status").get<std::string>());
  const bool remove = parsed.at("remove_when_done").get<bool>();
  ForgetFinished();
  const auto hook = hooks_.find({uid, ReadPosition(parsed)});
  if (hook == hooks_.end()) return Problem{groot2::kNoSuchNode};
  if (debugger_.where().hook == hook->second.id) debugger_.Continue(status);
  if (remove) {
    debugger_.Remove(hook->second.id);
    hooks_.erase(hook);
  }
  return {};
}

std::string Groot2Hooks::Dump() {
  ForgetFinished();
  Json list = Json::array();
  for (const auto& [place, hook] : hooks_) {
    list.push_back({{"enabled", hook.enabled},
                    {"uid", hook.uid},
                    {"mode", static_cast<int>(hook.mode)},
                    {"once", hook.once},
                    {"desired_status", hook.desired_status},
                    {"position", static_cast<int>(hook.position)}});
  }
  return list.dump();
}

void Groot2Hooks::RemoveAll() {
  debugger_.RemoveAllOf(owner_);
  hooks_.clear();
}

// One that replaces nothing stays as it is in the debugger.
void Groot2Hooks::SetAllEnabled(bool enabled) {
  for (auto& [place, hook] : hooks_) {
    hook.enabled = enabled;
    debugger_.SetEnabled(hook.id, Translate(hook).enabled);
  }
}

std::optional<std::uint16_t> Groot2Hooks::UidOf(HookId id) const {
  for (const auto& [place, hook] : hooks_) {
    if (hook.id == id) return hook.uid;
  }
  return std::nullopt;
}

// A hook that was to act once, and did, is no longer in the debugger.
void Groot2Hooks::ForgetFinished() {
  for (auto hook = hooks_.begin(); hook != hooks_.end();) {
    hook = debugger_.Find(hook->second.id) ? std::next(hook) : hooks_.erase(hook);
  }
}

}  // namespace coppice
