#include "bt_core/live/server/extension_service.h"

#include <chrono>
#include <exception>
#include <nlohmann/json.hpp>

#include "bt_core/base/hex.h"
#include "bt_core/base/json_library.h"
#include "bt_core/base/version.h"
#include "bt_core/live/debug/hook_json.h"
#include "bt_core/live/server/extension_request.h"

namespace coppice {
namespace {

using Json = nlohmann::json;

std::string Print(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json WriteError(const RequestError& error) {
  Json json = {{"error", error.what()}};
  if (error.kind == RequestError::Kind::kRefused) json["reason"] = "refused";
  if (error.kind == RequestError::Kind::kRole) json["role"] = "control";
  return json;
}

std::int64_t Milliseconds(Duration duration) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(duration).count();
}

Json Greet(const LiveTrees& trees, bool may_control, Duration deadline, bool has_pictures) {
  Outcome permission;
  if (!trees.empty()) permission = trees.begin()->second->Permission();
  if (!may_control) permission = Problem{"this client may watch, not control"};
  Json json = {{"protocol", kExtensionVersion},
               {"coppice", kVersion},
               {"role", may_control ? "control" : "read"},
               {"deadline_ms", Milliseconds(deadline)},
               {"trees", ListTrees(trees)},
               {"pictures", has_pictures}};
  if (permission) {
    json["control"] = true;
  } else {
    json["control"] = permission.problem();
  }
  return json;
}

}  // namespace

ExtensionService::Answer ExtensionService::Serve(ClientId client, bool may_control,
                                                 std::string_view request, Duration now) {
  try {
    const Json json = ParseLimitedJson(request);
    const std::string what = json.at("do").get<std::string>();
    if (what == "hello") {
      Session* const session = sessions_.Open(client, may_control, now);
      if (!session) throw RequestError("too many clients");
      session->name = json.value("name", "");
      return {Print(Greet(trees_, may_control, deadline_, has_pictures_))};
    }
    Session* const session = sessions_.Find(client);
    if (!session) throw RequestError("say hello first");
    session->last_request = now;
    if (what == "bye") {
      sessions_.Close(client);
      return {"{}"};
    }
    return {Print(ExtensionRequest(json, trees_, *session, may_control).Run(what))};
  } catch (const RequestError& error) {
    return {Print(WriteError(error)), true};
  } catch (const std::exception& error) {
    return {Print({{"error", error.what()}}), true};
  }
}

std::string ExtensionService::Describe(std::uint32_t tree, const DebugEvent& event) const {
  Json notice = {{"tree", tree}};
  switch (event.kind) {
    case DebugEvent::Kind::kStopped:
      notice["event"] = "stopped";
      break;
    case DebugEvent::Kind::kResumed:
      notice["event"] = "resumed";
      break;
    case DebugEvent::Kind::kReplaced:
      notice["event"] = "replaced";
      break;
    case DebugEvent::Kind::kRefused:
      notice["event"] = "refused";
      notice["text"] = event.reason;
      break;
  }
  if (event.kind != DebugEvent::Kind::kResumed) {
    notice["stop"] = WriteStop(event.stop, *trees_.at(tree)->program());
  }
  return Print(notice);
}

std::string ExtensionService::DescribeTrees() const {
  return Print({{"event", "trees"}, {"trees", ListTrees(trees_)}});
}

std::string ExtensionService::DescribeRelease() const {
  return Print({{"event", "released"},
                {"text", "nothing was heard from this client for " +
                             std::to_string(Milliseconds(deadline_)) + " ms; say hello again"}});
}

std::string ExtensionService::Describe(const LivePicture& picture) {
  return Print({{"event", "picture"},
                {"name", picture.name},
                {"text", picture.text},
                {"width", picture.width},
                {"height", picture.height},
                {"rgb", ToHex(picture.rgb)}});
}

}  // namespace coppice
