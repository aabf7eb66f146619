#include "editor/live/kept_marks.h"

#include <exception>
#include <nlohmann/json.hpp>
#include <utility>

#include "editor/live/record_source.h"

namespace coppice::editor {
namespace {

using Json = nlohmann::json;

Json WriteBreakpoint(const WantedHook& wanted) {
  Json json = {{"path", wanted.hook.path}};
  if (!wanted.robot.empty()) json["robot"] = wanted.robot;
  if (wanted.hook.position == HookPosition::kAfter) json["position"] = "after";
  if (!wanted.hook.condition.empty()) json["condition"] = wanted.hook.condition;
  if (wanted.hook.from_hit > 1) json["from_hit"] = wanted.hook.from_hit;
  if (!wanted.hook.enabled) json["enabled"] = false;
  return json;
}

WantedHook ReadBreakpoint(const Json& json) {
  WantedHook wanted;
  wanted.robot = json.value("robot", "");
  wanted.hook.path = json.at("path").get<std::string>();
  if (json.value("position", "before") == "after") wanted.hook.position = HookPosition::kAfter;
  wanted.hook.condition = json.value("condition", "");
  wanted.hook.from_hit = json.value("from_hit", 1U);
  wanted.hook.enabled = json.value("enabled", true);
  return wanted;
}

}  // namespace

std::string WriteMarks(const HookList& hooks, const Bookmarks& bookmarks) {
  Json breakpoints = Json::array();
  for (const WantedHook& wanted : hooks.all()) {
    const bool stays = IsBreakpoint(wanted.hook) && wanted.hook.times == 0;
    if (stays) breakpoints.push_back(WriteBreakpoint(wanted));
  }
  Json places = Json::object();
  for (const auto& [run, ticks] : bookmarks.all()) {
    if (!IsRecordName(run)) continue;  // what a robot did is gone with the editor
    for (const auto& [tick, text] : ticks) places[run].push_back({{"tick", tick}, {"text", text}});
  }
  const Json all = {{"breakpoints", std::move(breakpoints)}, {"bookmarks", std::move(places)}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void ReadMarks(const std::string& text, const std::string& file, HookList& hooks,
               Bookmarks& bookmarks, Diagnostics& diagnostics) {
  try {
    const Json all = Json::parse(text);
    std::vector<WantedHook> breakpoints;
    for (const Json& json : all.at("breakpoints")) breakpoints.push_back(ReadBreakpoint(json));
    Bookmarks read;
    for (const auto& [run, places] : all.at("bookmarks").items()) {
      for (const Json& place : places) {
        read.Set(run, place.at("tick").get<std::size_t>(), place.value("text", ""));
      }
    }
    for (WantedHook& wanted : breakpoints) hooks.Add(wanted.robot, std::move(wanted.hook));
    for (const auto& [run, ticks] : read.all()) {
      for (const auto& [tick, words] : ticks) bookmarks.Set(run, tick, words);
    }
  } catch (const std::exception& wrong) {
    diagnostics.Warning({file, 0, 0},
                        std::string("breakpoints and bookmarks are not read: ") + wrong.what());
  }
}

}  // namespace coppice::editor
