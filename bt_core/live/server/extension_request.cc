#include "bt_core/live/server/extension_request.h"

#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>

#include "bt_core/base/json_library.h"
#include "bt_core/live/debug/hook_json.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

void Check(const Outcome& outcome, RequestError::Kind kind = RequestError::Kind::kWrong) {
  if (!outcome) throw RequestError(outcome.problem(), kind);
}

std::uint64_t ReadNumber(const Json& json, const char* member) {
  const Json& number = json.at(member);
  if (number.is_number_unsigned()) return number.get<std::uint64_t>();
  throw RequestError(std::string(member) + ": expected a whole number that is not negative");
}

std::uint64_t ReadNumber(const Json& json, const char* member, std::uint64_t otherwise) {
  return json.contains(member) ? ReadNumber(json, member) : otherwise;
}

}  // namespace

const ExtensionRequest::Kind ExtensionRequest::kKinds[] = {
    {"trees", false, false, &ExtensionRequest::Trees},
    {"ping", false, false, &ExtensionRequest::Ping},
    {"subscribe", false, false, &ExtensionRequest::Subscribe},
    {"ack", false, false, &ExtensionRequest::Acknowledge},
    {"unsubscribe", false, false, &ExtensionRequest::Unsubscribe},
    {"statistics", false, false, &ExtensionRequest::Statistics},
    {"hooks", false, false, &ExtensionRequest::ListHooks},
    {"pictures", false, false, &ExtensionRequest::SendPictures},
    {"write", true, true, &ExtensionRequest::Write},
    {"pause", true, true, &ExtensionRequest::Pause},
    {"step", true, true, &ExtensionRequest::Step},
    {"hook", true, true, &ExtensionRequest::AddHook},
    {"continue", true, false, &ExtensionRequest::Continue},
    {"unhook", true, false, &ExtensionRequest::RemoveHook},
    {"enable", true, false, &ExtensionRequest::EnableHook},
};

Json ListTrees(const LiveTrees& trees) {
  Json list = Json::array();
  for (const auto& [number, tree] : trees) {
    const LiveTreeInfo info = tree->Info();
    list.push_back({{"tree", number},
                    {"name", info.name},
                    {"run", ToString(info.run)},
                    {"nodes", info.nodes},
                    {"tick", info.tick},
                    {"first_frame", info.first_frame},
                    {"next_frame", info.next_frame},
                    {"lost_ticks", info.lost_ticks},
                    {"recording_dropped", info.recording_dropped},
                    {"stop", WriteStop(tree->debugger().where(), *tree->program())}});
  }
  return list;
}

Json ExtensionRequest::Run(const std::string& what) {
  const Kind& kind = KindOf(what);
  CheckAllowed(kind);
  return (this->*kind.handler)();
}

const ExtensionRequest::Kind& ExtensionRequest::KindOf(const std::string& what) {
  for (const Kind& kind : kKinds) {
    if (what == kind.name) return kind;
  }
  throw RequestError("\"" + what + "\" is no request of this version");
}

void ExtensionRequest::CheckAllowed(const Kind& kind) const {
  if (!kind.controls) return;
  if (!may_control_) {
    throw RequestError("this client may watch, not control: its token is for readers",
                       RequestError::Kind::kRole);
  }
  const LiveTree& tree = Tree();
  if (!kind.disturbs && !tree.options().read_only) return;
  Check(tree.Permission(), RequestError::Kind::kRefused);
}

std::shared_ptr<LiveTree> ExtensionRequest::SharedTree() const {
  const std::uint64_t number =
      ReadNumber(json_, "tree", trees_.empty() ? 0 : trees_.begin()->first);
  const auto tree =
      number <= UINT32_MAX ? trees_.find(static_cast<std::uint32_t>(number)) : trees_.end();
  if (tree == trees_.end()) throw RequestError("there is no tree " + std::to_string(number));
  return tree->second;
}

Json ExtensionRequest::Trees() { return {{"trees", ListTrees(trees_)}}; }

Json ExtensionRequest::Ping() { return Json::object(); }

Json ExtensionRequest::SendPictures() {
  session_.pictures_seen = 0;
  return Json::object();
}

Json ExtensionRequest::Subscribe() {
  const std::shared_ptr<LiveTree> tree = SharedTree();
  const std::string run = ToString(tree->run());
  auto from = Subscription::From::kOldest;
  std::uint64_t number = 0;
  const auto wanted = json_.find("from");
  if (wanted != json_.end() && wanted->is_string() && *wanted == "now") {
    from = Subscription::From::kYoungest;
  } else if (wanted != json_.end()) {
    number = ReadNumber(json_, "from");
    if (json_.value("run", run) == run) from = Subscription::From::kNumber;
  }
  const std::uint64_t window = ReadNumber(json_, "window", Subscription::kDefaultWindow);
  session_.Unfollow(*tree);
  const std::uint32_t id = ++session_.last_subscription;
  const auto at = session_.subscriptions.try_emplace(id, tree, from, number, window).first;
  return {{"subscription", id},
          {"run", run},
          {"next", at->second.frames.next()},
          {"missed", at->second.frames.missed()}};
}

std::map<std::uint32_t, ActiveSubscription>::iterator ExtensionRequest::FindSubscription() {
  const std::uint64_t id = ReadNumber(json_, "subscription");
  const auto at = session_.subscriptions.find(static_cast<std::uint32_t>(id));
  if (id > UINT32_MAX || at == session_.subscriptions.end()) {
    throw RequestError("there is no subscription " + std::to_string(id));
  }
  return at;
}

Json ExtensionRequest::Acknowledge() {
  FindSubscription()->second.frames.Acknowledge(ReadNumber(json_, "next"));
  return Json::object();
}

Json ExtensionRequest::Unsubscribe() {
  session_.subscriptions.erase(FindSubscription());
  return Json::object();
}

Json ExtensionRequest::Statistics() {
  const LiveTree& tree = Tree();
  return {{"ticks", tree.Info().tick}, {"nodes", tree.Counts().items}};
}

Json ExtensionRequest::Write() {
  const bool is_text = json_.contains("text");
  const std::string value = is_text ? json_["text"].get<std::string>() : json_.at("value").dump();
  Check(Tree().Write(json_.value("scope", ""), json_.at("key").get<std::string>(), value, is_text));
  return Json::object();
}

Json ExtensionRequest::Pause() {
  Check(Tree().debugger().Pause(session_.owner));
  return Json::object();
}

Json ExtensionRequest::Step() {
  const std::string to = json_.value("to", "tick");
  Debugger& debugger = Tree().debugger();
  if (to != "node" && to != "tick") {
    throw RequestError("to: expected \"node\" or \"tick\", not \"" + to + "\"");
  }
  Check(to == "node" ? debugger.StepNode(session_.owner) : debugger.StepTick(session_.owner));
  return Json::object();
}

Json ExtensionRequest::Continue() {
  std::optional<Status> result;
  if (json_.contains("result")) result = ReadStatus(json_["result"].get<std::string>());
  LiveTree& tree = Tree();
  if (result) Check(tree.Permission(), RequestError::Kind::kRefused);
  tree.debugger().Continue(result);
  return Json::object();
}

Json ExtensionRequest::AddHook() {
  Debugger& debugger = Tree().debugger();
  const Hook hook = ReadHook(json_);
  const Expected<HookAnswer> answer = json_.contains("hook") ? debugger.Change(NumberOfHook(), hook)
                                                             : debugger.Add(hook, session_.owner);
  if (!answer) throw RequestError(answer.problem());
  Json reply = {{"hook", answer->id}};
  if (!answer->remark.empty()) reply["remark"] = answer->remark;
  return reply;
}

HookId ExtensionRequest::NumberOfHook() const {
  const std::uint64_t number = ReadNumber(json_, "hook");
  if (number > UINT32_MAX) throw RequestError("there is no hook " + std::to_string(number));
  return static_cast<HookId>(number);
}

Json ExtensionRequest::RemoveHook() {
  Debugger& debugger = Tree().debugger();
  if (!json_.contains("hook")) {
    debugger.RemoveAllOf(session_.owner);
  } else if (!debugger.Remove(NumberOfHook())) {
    throw RequestError("there is no hook " + std::to_string(NumberOfHook()));
  }
  return Json::object();
}

Json ExtensionRequest::EnableHook() {
  if (!Tree().debugger().SetEnabled(NumberOfHook(), json_.at("enabled").get<bool>())) {
    throw RequestError("there is no hook " + std::to_string(NumberOfHook()));
  }
  return Json::object();
}

Json ExtensionRequest::ListHooks() {
  LiveTree& tree = Tree();
  Json list = Json::array();
  for (const HookInfo& info : tree.debugger().hooks()) {
    list.push_back(WriteHook(info, info.owner == session_.owner));
  }
  return {{"hooks", std::move(list)},
          {"stop", WriteStop(tree.debugger().where(), *tree.program())}};
}

}  // namespace coppice
