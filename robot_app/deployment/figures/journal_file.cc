#include "robot_app/deployment/figures/journal_file.h"

#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "bt_core/base/json_library.h"
#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::robot::deployment {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr std::int64_t kLatest = std::int64_t{1} << 62U;  // ns; until then can be calculated

Json FromTime(Time time) { return time == kNever ? Json() : Json(ToNanoseconds(time)); }
Time ToTime(const Json& json) {
  const auto nanoseconds = json.get<std::int64_t>();
  if (nanoseconds < 0 || nanoseconds > kLatest) throw std::out_of_range("no such time");
  return TimeFromNanoseconds(nanoseconds);
}

Json FromInterval(const Interval& interval) {
  return Json::array({FromTime(interval.from), FromTime(interval.to)});
}
Interval ToInterval(const Json& json) { return {ToTime(json.at(0)), ToTime(json.at(1))}; }

Json From(const Interval& interval) { return FromInterval(interval); }
void To(const Json& json, Interval& interval) { interval = ToInterval(json); }

Json From(const Span& span) {
  return Json::array(
      {FromTime(span.when.from), FromTime(span.when.to), static_cast<int>(span.activity)});
}
void To(const Json& json, Span& span) {
  const int activity = json.at(2).get<int>();
  if (activity < 0 || activity >= kActivities) throw std::out_of_range("no such activity");
  span = {ToInterval(json), static_cast<Activity>(activity)};
}

Json From(const leaves::RecoveryEvent& event) {
  Json json = {{"recovery", event.recovery},
               {"subject", event.subject},
               {"phase", static_cast<int>(event.phase)},
               {"attempt", event.attempt},
               {"time", FromTime(event.time)}};
  if (event.pose) json["pose"] = {event.pose->x, event.pose->y, event.pose->yaw};
  if (!event.message.empty()) json["message"] = event.message;
  return json;
}
void To(const Json& json, leaves::RecoveryEvent& event) {
  event.recovery = json.at("recovery");
  event.subject = json.at("subject");
  const int phase = json.at("phase");
  if (phase < 0 || phase > static_cast<int>(leaves::RecoveryPhase::kRefused)) {
    throw std::out_of_range("no such phase");
  }
  event.phase = static_cast<leaves::RecoveryPhase>(phase);
  event.attempt = json.at("attempt");
  event.time = ToTime(json.at("time"));
  if (json.contains("pose")) {
    const Json& pose = json["pose"];
    event.pose = leaves::Pose2D{pose.at(0), pose.at(1), pose.at(2)};
  }
  event.message = json.value("message", "");
}

Json From(const Request& request) {
  return {{"subject", request.subject},
          {"asked", FromTime(request.asked)},
          {"closed", FromTime(request.closed)},
          {"fixed", request.is_fixed},
          {"outcome", request.outcome}};
}
void To(const Json& json, Request& request) {
  const Json& closed = json.at("closed");
  request = {json.at("subject"), ToTime(json.at("asked")),
             closed.is_null() ? kNever : ToTime(closed), json.at("fixed"), json.at("outcome")};
}

Json From(const UnplannedStop& stop) {
  return {{"at", FromTime(stop.at)}, {"cause", stop.cause}, {"what", stop.what}};
}
void To(const Json& json, UnplannedStop& stop) {
  stop = {ToTime(json.at("at")), json.at("cause"), json.at("what")};
}

Json From(const Docking& docking) {
  return {{"begun", FromTime(docking.begun)},
          {"attempts", docking.attempts},
          {"docked", docking.is_docked},
          {"current", docking.has_current},
          {"seconds", docking.seconds}};
}
void To(const Json& json, Docking& docking) {
  docking = {ToTime(json.at("begun")), json.at("attempts"), json.at("docked"), json.at("current"),
             json.at("seconds")};
}

Json From(const ProgramStart& start) {
  return {{"group", start.group},
          {"failed", FromTime(start.failed)},
          {"seconds", start.seconds},
          {"fault", start.fault}};
}
void To(const Json& json, ProgramStart& start) {
  start = {json.at("group"), ToTime(json.at("failed")), json.at("seconds"), json.at("fault")};
}

Json From(const OccurredFault& fault) {
  return {{"at", FromTime(fault.at)},
          {"fault", fault.fault},
          {"what", fault.what},
          {"lasts", fault.lasts}};
}
void To(const Json& json, OccurredFault& fault) {
  fault = {ToTime(json.at("at")), json.at("fault"), json.at("what"), json.at("lasts")};
}

Json From(const BatterySample& sample) { return Json::array({FromTime(sample.at), sample.level}); }
void To(const Json& json, BatterySample& sample) { sample = {ToTime(json.at(0)), json.at(1)}; }

template <class T>
Json FromList(const std::vector<T>& list) {
  Json json = Json::array();
  for (const T& item : list) json.push_back(From(item));
  return json;
}
template <class T>
void ToList(const Json& json, std::vector<T>& list) {
  for (const Json& item : json) To(item, list.emplace_back());
}

Journal FromJson(const Json& json) {
  if (json.at("version") != kVersion) throw std::out_of_range("another version");
  Journal journal;
  journal.controller = json.at("controller");
  journal.seed = json.at("seed");
  journal.times = json.at("times");
  journal.without = json.at("without").get<std::vector<std::string>>();
  journal.span = ToInterval(json.at("span"));
  ToList(json.at("duties"), journal.duties);
  ToList(json.at("spans"), journal.spans);
  ToList(json.at("stands"), journal.stands);
  ToList(json.at("recoveries"), journal.recoveries);
  ToList(json.at("requests"), journal.requests);
  ToList(json.at("stops"), journal.stops);
  ToList(json.at("dockings"), journal.dockings);
  ToList(json.at("starts"), journal.starts);
  ToList(json.value("faults", Json::array()), journal.faults);  // older files have none
  ToList(json.at("battery"), journal.battery);
  journal.distance = json.at("distance");
  journal.with_mask = json.at("with_mask");
  journal.without_mask = json.at("without_mask");
  journal.cpu_seconds = json.at("cpu_seconds");
  journal.records = json.at("records").get<std::vector<std::string>>();
  return journal;
}

}  // namespace

std::string ToText(const Journal& journal) {
  const Json json = {{"version", kVersion},
                     {"controller", journal.controller},
                     {"seed", journal.seed},
                     {"times", journal.times},
                     {"without", journal.without},
                     {"span", FromInterval(journal.span)},
                     {"duties", FromList(journal.duties)},
                     {"spans", FromList(journal.spans)},
                     {"stands", FromList(journal.stands)},
                     {"recoveries", FromList(journal.recoveries)},
                     {"requests", FromList(journal.requests)},
                     {"stops", FromList(journal.stops)},
                     {"dockings", FromList(journal.dockings)},
                     {"starts", FromList(journal.starts)},
                     {"faults", FromList(journal.faults)},
                     {"battery", FromList(journal.battery)},
                     {"distance", journal.distance},
                     {"with_mask", journal.with_mask},
                     {"without_mask", journal.without_mask},
                     {"cpu_seconds", journal.cpu_seconds},
                     {"records", journal.records}};
  return json.dump() + "\n";
}

Expected<Journal> JournalFromText(const std::string& text) {
  try {
    return FromJson(ParseLimitedJson(text, kMostOwnJsonValues));
  } catch (const std::exception& error) {
    return Problem{std::string("it is no journal of a deployment: ") + error.what()};
  }
}

Outcome SaveJournal(const Journal& journal, const std::string& path) {
  Diagnostics diagnostics;
  if (WriteFile(path, ToText(journal), diagnostics)) return {};
  return Problem{diagnostics.ToString()};
}

Expected<Journal> LoadJournal(const std::string& path) {
  Diagnostics diagnostics;
  const auto text = ReadFile(path, diagnostics);
  if (!text) return Problem{diagnostics.ToString()};
  auto journal = JournalFromText(*text);
  if (!journal) return Problem{path + ": " + journal.problem()};
  return journal;
}

}  // namespace coppice::robot::deployment
