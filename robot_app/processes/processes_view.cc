#include "robot_app/processes/processes_view.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "bt_core/model/utf8.h"
#include "robot_app/processes/escalation.h"
#include "robot_app/processes/launch/lifecycle.h"

namespace coppice::robot::processes {
namespace {

using coppice_msgs::ProcessState;

using Row = std::vector<std::string>;

// "45 s", "12 min", "3 h", "2 d".
std::string Rough(double seconds) {
  if (seconds < 100) return std::to_string(static_cast<int>(seconds)) + " s";
  if (seconds < 6000) return std::to_string(static_cast<int>(seconds / 60)) + " min";
  if (seconds < 360000) return std::to_string(static_cast<int>(seconds / 3600)) + " h";
  return std::to_string(static_cast<int>(seconds / 86400)) + " d";
}

// Whoever publishes the states says nothing to the terminal, and no line is wider than it should.
std::string Cell(const std::string& text) {
  constexpr std::size_t kWidest = 300;
  return PlainText(text, kWidest);
}

std::string StateName(const ProcessState& process) {
  return ToString(static_cast<ProcessPhase>(process.state));
}

std::string StepName(const ProcessState& process) {
  return ToString(static_cast<EscalationStep>(process.escalation));
}

Row ToRow(const ProcessState& process, double now) {
  std::string message = process.message;
  if (!process.back_off_until.isZero()) {
    const double left = std::max(0.0, process.back_off_until.toSec() - now);
    message += "; again in " + Rough(left);
  }
  return {
      Cell(process.name),
      Cell(process.group),
      process.host.empty() ? "-" : Cell(process.host),
      StateName(process),
      process.since.isZero() ? "-" : Rough(now - process.since.toSec()),
      process.pid == 0 ? "-" : std::to_string(process.pid),
      std::to_string(process.restarts),
      std::to_string(process.restarts_in_window) + "/" + std::to_string(process.restarts_allowed),
      StepName(process),
      Cell(message)};
}

std::string Align(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::ostringstream text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text << line << "\n";
  }
  return text.str();
}

using Json = nlohmann::ordered_json;
using Handler = Json::error_handler_t;

Json JsonRows(const coppice_msgs::ProcessStates& states) {
  Json rows = Json::array();
  for (const ProcessState& process : states.processes) {
    rows.push_back({{"name", process.name},
                    {"node", process.node},
                    {"group", process.group},
                    {"host", process.host},
                    {"state", StateName(process)},
                    {"pid", process.pid},
                    {"restarts", process.restarts},
                    {"restarts_in_window", process.restarts_in_window},
                    {"restarts_allowed", process.restarts_allowed},
                    {"escalation", StepName(process)},
                    {"since", process.since.toSec()},
                    {"back_off_until", process.back_off_until.toSec()},
                    {"message", process.message}});
  }
  return rows;
}

}  // namespace

std::string ToTable(const coppice_msgs::ProcessStates& states, Time now) {
  std::vector<Row> rows = {
      {"PROCESS", "GROUP", "HOST", "STATE", "FOR", "PID", "RESTARTS", "USED", "STEP", "MESSAGE"}};
  const double seconds = std::chrono::duration<double>(now.time_since_epoch()).count();
  for (const ProcessState& process : states.processes) rows.push_back(ToRow(process, seconds));
  return (states.site.empty() ? "" : "site " + Cell(states.site) + ", ") + "configuration " +
         Cell(states.configuration) + (states.manual ? ", held by hand" : "") +
         (states.changing ? ", changing" : "") + (states.safe_stop ? ", SAFE STOP" : "") + "\n" +
         Align(rows);
}

std::string ToJson(const coppice_msgs::ProcessStates& states) {
  const Json value = {{"site", states.site},
                      {"configuration", states.configuration},
                      {"changing", static_cast<bool>(states.changing)},
                      {"manual", static_cast<bool>(states.manual)},
                      {"safe_stop", static_cast<bool>(states.safe_stop)},
                      {"processes", JsonRows(states)}};
  return value.dump(2, ' ', false, Handler::replace) + "\n";
}

std::string ToJsonRows(const coppice_msgs::ProcessStates& states) {
  return JsonRows(states).dump(-1, ' ', false, Handler::replace);
}

bool IsAsItShouldBe(const coppice_msgs::ProcessStates& states) {
  return !states.changing && !states.safe_stop &&
         std::none_of(
             states.processes.begin(), states.processes.end(),
             [](const ProcessState& process) { return process.state == ProcessState::GIVEN_UP; });
}

}  // namespace coppice::robot::processes
