#include "editor/live/kept_marks.h"

#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "bt_core/base/json_library.h"
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

Json WriteLogPoint(const LogPoint& point) {
  Json json = {{"path", point.path}};
  if (!point.run.empty()) json["run"] = point.run;
  if (!point.text.empty()) json["text"] = point.text;
  if (!point.condition.empty()) json["condition"] = point.condition;
  if (point.from_hit > 1) json["from_hit"] = point.from_hit;
  if (!point.enabled) json["enabled"] = false;
  return json;
}

LogPoint ReadLogPoint(const Json& json) {
  LogPoint point;
  point.run = json.value("run", "");
  point.path = json.at("path").get<std::string>();
  point.text = json.value("text", "");
  point.condition = json.value("condition", "");
  point.from_hit = json.value("from_hit", 1U);
  point.enabled = json.value("enabled", true);
  return point;
}

// Files of an older editor lack some.
Json PartOf(const Json& all, const char* name, Json otherwise) {
  return all.contains(name) ? all.at(name) : std::move(otherwise);
}

}  // namespace

bool HasAny(const Marks& marks) {
  HookList hooks;
  LogPoints log_points;
  Bookmarks bookmarks;
  LanePins pins;
  return WriteMarks(marks) != WriteMarks({hooks, log_points, bookmarks, pins});
}

std::string WriteMarks(const Marks& marks) {
  Json breakpoints = Json::array();
  for (const WantedHook& wanted : marks.hooks.all()) {
    const bool stays = IsBreakpoint(wanted.hook) && wanted.hook.times == 0;
    if (stays) breakpoints.push_back(WriteBreakpoint(wanted));
  }
  Json log_points = Json::array();
  for (const LogPoint& point : marks.log_points.all()) log_points.push_back(WriteLogPoint(point));
  Json places = Json::object();
  for (const auto& [run, ticks] : marks.bookmarks.all()) {
    if (!IsRecordName(run)) continue;  // what a robot did is gone with the editor
    for (const auto& [tick, text] : ticks) places[run].push_back({{"tick", tick}, {"text", text}});
  }
  const Json all = {{"breakpoints", std::move(breakpoints)},
                    {"log_points", std::move(log_points)},
                    {"bookmarks", std::move(places)},
                    {"pins", marks.pins.all()}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void ReadMarks(const std::string& text, const std::string& file, const Marks& marks,
               Diagnostics& diagnostics) {
  try {
    const Json all = ParseLimitedJson(text);
    std::vector<WantedHook> breakpoints;
    for (const Json& json : all.at("breakpoints")) breakpoints.push_back(ReadBreakpoint(json));
    std::vector<LogPoint> log_points;
    for (const Json& json : PartOf(all, "log_points", Json::array())) {
      log_points.push_back(ReadLogPoint(json));
    }
    Bookmarks read;
    for (const auto& [run, places] : all.at("bookmarks").items()) {
      for (const Json& place : places) {
        read.Set(run, place.at("tick").get<std::size_t>(), place.value("text", ""));
      }
    }
    const auto pins =
        PartOf(all, "pins", Json::object()).get<std::map<std::string, std::vector<std::string>>>();
    for (WantedHook& wanted : breakpoints) marks.hooks.Add(wanted.robot, std::move(wanted.hook));
    for (LogPoint& point : log_points) marks.log_points.Add(std::move(point));
    for (const auto& [run, ticks] : read.all()) {
      for (const auto& [tick, words] : ticks) marks.bookmarks.Set(run, tick, words);
    }
    for (const auto& [run, paths] : pins) {
      for (const std::string& path : paths) {
        if (!marks.pins.Has(run, path)) marks.pins.Toggle(run, path);
      }
    }
  } catch (const std::exception& wrong) {
    diagnostics.Warning({file, 0, 0},
                        std::string("breakpoints and bookmarks are not read: ") + wrong.what());
  }
}

}  // namespace coppice::editor
