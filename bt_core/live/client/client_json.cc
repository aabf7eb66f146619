#include "bt_core/live/client/client_json.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "bt_core/base/hex.h"
#include "bt_core/base/json_library.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

constexpr int kProtocol = 1;

std::string Print(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// An empty object if it is none: then all members are missing.
Json Parse(std::string_view text) {
  try {
    Json json = ParseLimitedJson(text);
    if (json.is_object()) return json;
  } catch (const std::exception&) {  // it is no JSON
  }
  return Json::object();
}

std::string TextOf(const Json& json, const char* member) {
  const auto at = json.find(member);
  return at != json.end() && at->is_string() ? at->get<std::string>() : std::string();
}

std::uint64_t NumberOf(const Json& json, const char* member) {
  const auto at = json.find(member);
  return at != json.end() && at->is_number_unsigned() ? at->get<std::uint64_t>() : 0;
}

Outcome OutcomeOf(const Json& json) {
  if (!json.contains("error")) return {};
  std::string error = TextOf(json, "error");
  return Problem{error.empty() ? "the robot refuses without a reason" : std::move(error)};
}

std::vector<std::string> TreesOf(const Json& json) {
  std::vector<std::string> names;
  const auto at = json.find("trees");
  if (at == json.end() || !at->is_array()) return names;
  for (const Json& tree : *at) {
    if (!tree.is_object()) continue;
    const std::size_t number = NumberOf(tree, "tree");
    if (number > 1000) continue;  // no such robot
    names.resize(std::max(names.size(), number + 1));
    names[number] = TextOf(tree, "name");
  }
  return names;
}

Status StatusOf(const std::string& name) {
  for (const Status status :
       {Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    if (name == ToString(status)) return status;
  }
  return Status::kIdle;
}

DebugStop StopOf(const Json& json) {
  DebugStop stop;
  const std::string where = TextOf(json, "where");
  if (where == "between_ticks") stop.where = DebugStop::Where::kBetweenTicks;
  if (where == "before") stop.where = DebugStop::Where::kBefore;
  if (where == "after") stop.where = DebugStop::Where::kAfter;
  if (json.contains("node")) stop.node = static_cast<NodeIndex>(NumberOf(json, "node"));
  stop.result = StatusOf(TextOf(json, "result"));
  stop.hook = static_cast<HookId>(NumberOf(json, "hook"));
  stop.tick = NumberOf(json, "tick");
  return stop;
}

// What is too large for it becomes 0, which no picture has.
std::uint32_t SideOf(const Json& json, const char* member) {
  const std::uint64_t side = NumberOf(json, member);
  return side <= PictureSet::kMostPixels ? static_cast<std::uint32_t>(side) : 0;
}

LivePicture PictureOf(const Json& json) {
  return {TextOf(json, "name"), TextOf(json, "text"), SideOf(json, "width"), SideOf(json, "height"),
          FromHex(TextOf(json, "rgb"))};
}

Json WriteHookRequest(const Hook& hook) {
  Json json = {{"do", "hook"}};
  if (hook.path.empty()) {
    json["node"] = hook.node;
  } else {
    json["node"] = hook.path;
  }
  if (hook.position == HookPosition::kAfter) json["position"] = "after";
  if (hook.action == HookAction::kReplace) {
    json["action"] = "replace";
    json["status"] = ToString(hook.status);
  } else if (hook.action == HookAction::kDelay) {
    json["action"] = "delay";
    json["delay_ms"] = std::chrono::duration<double, std::milli>(hook.delay).count();
  }
  if (!hook.condition.empty()) json["condition"] = hook.condition;
  json["from_hit"] = hook.from_hit;
  json["times"] = hook.times;
  json["enabled"] = hook.enabled;
  return json;
}

Json WriteValueRequest(const LiveCommand& command) {
  Json json = {{"do", "write"}, {"scope", command.scope}, {"key", command.key}};
  if (command.is_json) {
    json["value"] = Json::parse(command.value, nullptr, false);
  } else {
    json["text"] = command.value;
  }
  return json;
}

Json WriteKnownCommand(const LiveCommand& command) {
  switch (command.kind) {
    case LiveCommand::Kind::kPause:
      return {{"do", "pause"}};
    case LiveCommand::Kind::kStepNode:
      return {{"do", "step"}, {"to", "node"}};
    case LiveCommand::Kind::kStepTick:
      return {{"do", "step"}, {"to", "tick"}};
    case LiveCommand::Kind::kContinue: {
      Json json = {{"do", "continue"}};
      if (command.result) json["result"] = ToString(*command.result);
      return json;
    }
    case LiveCommand::Kind::kAddHook:
      return WriteHookRequest(command.hook);
    case LiveCommand::Kind::kRemoveHook: {
      Json json = {{"do", "unhook"}};
      if (command.id != kNoHook) json["hook"] = command.id;
      return json;
    }
    case LiveCommand::Kind::kWrite:
      return WriteValueRequest(command);
  }
  return Json::object();
}

}  // namespace

std::string WriteHello(const std::string& name) {
  return Print({{"do", "hello"}, {"protocol", kProtocol}, {"name", name}});
}

std::string WriteCommand(const LiveCommand& command, std::size_t tree) {
  Json json = WriteKnownCommand(command);
  json["tree"] = tree;
  return Print(json);
}

std::string WriteSubscribe(const SubscribeRequest& request) {
  Json json = {{"do", "subscribe"}, {"tree", request.tree}};
  if (request.from) {
    json["run"] = ToString(request.run);
    json["from"] = *request.from;
  } else if (!request.with_past) {
    json["from"] = "now";
  }
  return Print(json);
}

std::string WriteAck(std::uint32_t subscription, std::uint64_t next) {
  return Print({{"do", "ack"}, {"subscription", subscription}, {"next", next}});
}

std::string WriteSimple(const char* what) { return Print({{"do", what}}); }

Expected<HelloReply> ReadHello(std::string_view text) {
  const Json json = Parse(text);
  if (const Outcome outcome = OutcomeOf(json); !outcome) return Problem{outcome.problem()};
  const int protocol = static_cast<int>(NumberOf(json, "protocol"));
  if (protocol != kProtocol) {
    return Problem{"the robot speaks version " + std::to_string(protocol) +
                   " of the live protocol, this program version " + std::to_string(kProtocol)};
  }
  const auto pictures = json.find("pictures");
  return HelloReply{TextOf(json, "control"), TreesOf(json),
                    pictures != json.end() && *pictures == true};
}

Expected<SubscribeReply> ReadSubscribe(std::string_view text) {
  const Json json = Parse(text);
  if (const Outcome outcome = OutcomeOf(json); !outcome) return Problem{outcome.problem()};
  SubscribeReply reply;
  reply.subscription = static_cast<std::uint32_t>(NumberOf(json, "subscription"));
  reply.run = ReadRunId(TextOf(json, "run"));
  reply.next = NumberOf(json, "next");
  reply.missed = NumberOf(json, "missed");
  return reply;
}

LiveReply ReadReply(std::string_view text) {
  const Json json = Parse(text);
  if (const Outcome outcome = OutcomeOf(json); !outcome) return Problem{outcome.problem()};
  return HookAnswer{static_cast<HookId>(NumberOf(json, "hook")), TextOf(json, "remark")};
}

std::string WriteAbandoned(const std::string& why) { return Print({{"error", why}}); }

NoticeMessage ReadNotice(std::string_view text) {
  const Json json = Parse(text);
  NoticeMessage message;
  message.event = TextOf(json, "event");
  message.tree = NumberOf(json, "tree");
  message.trees = TreesOf(json);
  if (message.event == "picture") {
    message.picture = PictureOf(json);
    return message;
  }
  DebugEvent& event = message.notice.event;
  event.kind = message.event == "resumed"    ? DebugEvent::Kind::kResumed
               : message.event == "replaced" ? DebugEvent::Kind::kReplaced
               : message.event == "refused"  ? DebugEvent::Kind::kRefused
                                             : DebugEvent::Kind::kStopped;
  event.reason = TextOf(json, "text");
  const auto stop = json.find("stop");
  if (stop != json.end() && stop->is_object()) {
    event.stop = StopOf(*stop);
    message.notice.path = TextOf(*stop, "path");
  }
  return message;
}

RunId ReadRunId(std::string_view digits) {
  const std::vector<std::uint8_t> bytes = FromHex(digits);
  RunId run{};
  if (bytes.size() == run.size()) std::copy(bytes.begin(), bytes.end(), run.begin());
  return run;
}

}  // namespace coppice
