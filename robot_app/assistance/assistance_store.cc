#include "robot_app/assistance/assistance_store.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "bt_core/base/json_library.h"
#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;

template <class Enum>
Enum EnumOf(const json& number, Enum last) {
  const int value = number.get<int>();
  if (value < 0 || value > static_cast<int>(last)) throw std::out_of_range("unknown state");
  return static_cast<Enum>(value);
}

json ToJson(const HelpRequest& request) {
  json asked = json::array();
  for (const AskedSupervisor& one : request.asked) {
    asked.push_back({{"name", one.name}, {"state", static_cast<int>(one.state)}});
  }
  return {{"id", request.id},
          {"subject", request.subject},
          {"question", request.question},
          {"state", static_cast<int>(request.state)},
          {"opened", ToNanoseconds(request.opened)},
          {"deadline", ToNanoseconds(request.deadline)},
          {"ask_next_at", ToNanoseconds(request.ask_next_at)},
          {"remind_at", ToNanoseconds(request.remind_at)},
          {"withdrawn_at", ToNanoseconds(request.withdrawn_at)},
          {"asked", asked},
          {"taken_by", request.taken_by},
          {"answered_by", request.answered_by},
          {"ok", request.ok},
          {"message", request.message}};
}

HelpRequest ToRequest(const json& object) {
  const auto time = [&](const char* key) {
    return TimeFromNanoseconds(object.at(key).get<std::int64_t>());
  };
  HelpRequest request;
  request.id = object.at("id");
  request.subject = object.at("subject");
  request.question = object.at("question");
  request.state = EnumOf(object.at("state"), HelpState::kNobody);
  request.opened = time("opened");
  request.deadline = time("deadline");
  request.ask_next_at = time("ask_next_at");
  request.remind_at = time("remind_at");
  request.withdrawn_at = time("withdrawn_at");
  for (const json& one : object.at("asked")) {
    request.asked.push_back(
        {one.at("name"), EnumOf(one.at("state"), AskedSupervisor::State::kDeclined)});
  }
  request.taken_by = object.at("taken_by");
  request.answered_by = object.at("answered_by");
  request.ok = object.at("ok");
  request.message = object.at("message");
  return request;
}

json ToJson(const PageAccess::Passes& passes) {
  json list = json::object();
  for (const auto& [hash, pass] : passes) {
    list[hash] = {{"role", static_cast<int>(pass.role)},
                  {"name", pass.name},
                  {"request", pass.request},
                  {"until", ToNanoseconds(pass.until)}};
  }
  return list;
}

PageAccess::Passes ToPasses(const json& list) {
  PageAccess::Passes passes;
  for (const auto& [hash, pass] : list.items()) {
    passes[hash] = {EnumOf(pass.at("role"), PageRole::kOperator), pass.at("name"),
                    pass.at("request"), TimeFromNanoseconds(pass.at("until").get<std::int64_t>())};
  }
  return passes;
}

}  // namespace

std::string ToText(const AssistanceState& state) {
  json requests = json::array();
  for (const HelpRequest& request : state.requests) requests.push_back(ToJson(request));
  const json document = {{"requests", requests},
                         {"links", ToJson(state.passes.links)},
                         {"sessions", ToJson(state.passes.sessions)}};
  return document.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

AssistanceState ReadState(const std::string& text, Diagnostics& diagnostics) {
  try {
    const json document = ParseLimitedJson(text);
    AssistanceState state;
    for (const json& request : document.at("requests")) {
      state.requests.push_back(ToRequest(request));
    }
    state.passes.links = ToPasses(document.at("links"));
    state.passes.sessions = ToPasses(document.at("sessions"));
    return state;
  } catch (const std::exception& error) {
    diagnostics.Error({}, std::string("no open requests can be read: ") + error.what());
    return {};
  }
}

AssistanceState LoadState(const std::string& path, Diagnostics& diagnostics) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  const std::optional<std::string> text = ReadFile(path, diagnostics);
  return text ? ReadState(*text, diagnostics) : AssistanceState{};
}

bool SaveState(const std::string& path, const AssistanceState& state, Diagnostics& diagnostics) {
  return WriteFile(path, ToText(state), diagnostics, FileReaders::kOwnerOnly);
}

}  // namespace coppice::robot::assistance
