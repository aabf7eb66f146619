#include "bt_core/live/groot2/groot2_hook_json.h"

#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "bt_core/base/json_library.h"

namespace coppice::groot2 {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostHooks = 1000;  // that a robot is believed to have

int Number(HookPosition position) { return position == HookPosition::kBefore ? 0 : 1; }
HookPosition PositionOf(int number) {
  return number == 0 ? HookPosition::kBefore : HookPosition::kAfter;
}

// "instance/ID" of a node whose path is "instance/own".
std::string PathOfType(const DescribedNode& node) {
  const std::size_t slash = node.path.rfind('/');
  return slash == std::string::npos ? node.id : node.path.substr(0, slash + 1) + node.id;
}

std::vector<NodeIndex> FindExactly(const TreeDescription& tree, std::string_view path) {
  std::vector<NodeIndex> nodes;
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    if (tree.nodes[i].path == path) nodes.push_back(i);
  }
  if (!nodes.empty()) return nodes;
  for (NodeIndex i{0}; i < tree.nodes.size(); ++i) {
    if (PathOfType(tree.nodes[i]) == path) nodes.push_back(i);
  }
  return nodes;
}

}  // namespace

Outcome CheckHook(const Hook& hook) {
  if (!hook.condition.empty()) return Problem{"this robot knows no conditions"};
  if (hook.from_hit != 1 || hook.times > 1) {
    return Problem{"this robot does not count hits; it knows once"};
  }
  if (hook.action == HookAction::kDelay) return Problem{"this robot cannot delay a node"};
  if (hook.action == HookAction::kReplace && !IsCompleted(hook.status)) {
    return Problem{"on this robot only SUCCESS and FAILURE can be forced"};
  }
  return {};
}

std::string WriteHookInsert(const Hook& hook, std::uint16_t uid) {
  const bool replaces = hook.action == HookAction::kReplace;
  return Json{{"enabled", hook.enabled},
              {"uid", uid},
              {"mode", replaces ? 1 : 0},
              {"once", hook.times == 1},
              {"desired_status", replaces ? ToString(hook.status) : "SKIPPED"},
              {"position", Number(hook.position)}}
      .dump();
}

std::string WriteHookRemove(std::uint16_t uid, HookPosition position) {
  return Json{{"uid", uid}, {"position", Number(position)}}.dump();
}

std::string WriteUnlock(std::uint16_t uid, HookPosition position, std::optional<Status> result) {
  return Json{{"uid", uid},
              {"position", Number(position)},
              {"desired_status", ToString(result.value_or(Status::kSkipped))},
              {"remove_when_done", false}}
      .dump();
}

std::vector<ListedHook> ReadHooks(std::string_view json) {
  std::vector<ListedHook> hooks;
  try {
    for (const Json& item : ParseLimitedJson(json)) {
      ListedHook listed;
      listed.uid = item.at("uid").get<std::uint16_t>();
      Hook& hook = listed.hook;
      hook.enabled = item.at("enabled").get<bool>();
      hook.position = PositionOf(item.at("position").get<int>());
      hook.times = item.at("once").get<bool>() ? 1 : 0;
      if (item.at("mode").get<int>() != 0) hook.action = HookAction::kReplace;
      const std::string status = item.at("desired_status").get<std::string>();
      hook.status = status == "SUCCESS"   ? Status::kSuccess
                    : status == "FAILURE" ? Status::kFailure
                                          : Status::kSkipped;  // it replaces nothing
      hooks.push_back(std::move(listed));
      if (hooks.size() == kMostHooks) break;
    }
  } catch (const std::exception&) {  // what came until then are hooks
  }
  return hooks;
}

std::vector<NodeIndex> FindNodes(const TreeDescription& tree, std::string_view path) {
  std::vector<NodeIndex> nodes = FindExactly(tree, path);
  const std::string main = tree.main_tree + "/";
  if (!nodes.empty() || path.substr(0, main.size()) != main) return nodes;
  return FindExactly(tree, path.substr(main.size()));
}

}  // namespace coppice::groot2
