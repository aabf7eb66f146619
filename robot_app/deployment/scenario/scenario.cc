#include "robot_app/deployment/scenario/scenario.h"

#include <algorithm>

#include "robot_app/common/yaml_fields.h"

namespace coppice::robot::deployment {
namespace {

constexpr std::array<const char*, kFaults> kNames = {"blockage", "localization", "program",
                                                     "topic",    "crash_loop",   "charge_signal",
                                                     "docking",  "no_current",   "network"};

struct Entry {
  const char* name;
  double Scenario::*value;
  double low, high;
};

constexpr double kDay = 86400;

constexpr Entry kEntries[] = {
    {"blockage_passing", &Scenario::blockage_passing, 0, 1},
    {"blockage_trap", &Scenario::blockage_trap, 0, 1},
    {"again_after_passing", &Scenario::again_after_passing, 0, 1},
    {"again_after_trap", &Scenario::again_after_trap, 0, 1},
    {"passing_shortest", &Scenario::passing_shortest, 0, kDay},
    {"passing_longest", &Scenario::passing_longest, 0, kDay},
    {"people_noticed", &Scenario::people_noticed, 0, 1},
    {"closed_at_door", &Scenario::closed_at_door, 0, 1},
    {"closed_lasts", &Scenario::closed_lasts, 0, kDay},
    {"lost_transient", &Scenario::lost_transient, 0, 1},
    {"lost_inside", &Scenario::lost_inside, 0, 1},
    {"hang_share", &Scenario::hang_share, 0, 1},
    {"loop_crash_earliest", &Scenario::loop_crash_earliest, 0.1, kDay},
    {"loop_crash_latest", &Scenario::loop_crash_latest, 0.1, kDay},
    {"loop_takes_others", &Scenario::loop_takes_others, 0, 1},
    {"loop_in_program", &Scenario::loop_in_program, 0, 1},
    {"loop_noticed_after", &Scenario::loop_noticed_after, 1, 1e6},
    {"docking_persistent", &Scenario::docking_persistent, 0, 1},
    {"no_current_press_on", &Scenario::no_current_press_on, 0, 1},
    {"network_median", &Scenario::network_median, 1, kDay},
    {"answer_median", &Scenario::answer_median, 1, kDay},
    {"answer_sigma", &Scenario::answer_sigma, 0, 10},
    {"answer_never", &Scenario::answer_never, 0, 1},
    {"service_shortest", &Scenario::service_shortest, 0, kDay},
    {"service_longest", &Scenario::service_longest, 0, kDay},
    {"notice_after", &Scenario::notice_after, 60, kDay},
    {"notice_median", &Scenario::notice_median, 1, kDay},
    {"low_battery_seen", &Scenario::low_battery_seen, 0, 1},
    {"operator_from", &Scenario::operator_from, 0, 24},
    {"operator_to", &Scenario::operator_to, 0, 24},
    {"effective_speed", &Scenario::effective_speed, 0.01, 5},
    {"command_speed", &Scenario::command_speed, 0.01, 5},
    {"faces_per_hour", &Scenario::faces_per_hour, 0, 1e4},
    {"faces_without_mask", &Scenario::faces_without_mask, 0, 1},
    {"program_start_shortest", &Scenario::program_start_shortest, 0.1, 600},
    {"program_start_longest", &Scenario::program_start_longest, 0.1, 600},
};

double ReadNumber(YamlFields& section, const char* name, double low, double high,
                  Scenario& scenario) {
  if (!section.Has(name)) {
    section.Error(section.where(), std::string("\"") + name + "\" is missing");
    return 0;
  }
  YamlFields fields = section.Map(name);
  SourcedNumber number;
  number.name = name;
  number.value = fields.Number("value", low, low, high);
  number.unit = fields.Text("unit", "").text;
  number.source = fields.Text("source").text;
  fields.Finish();
  scenario.numbers.push_back(number);
  return number.value;
}

Time ReadMoment(YamlFields& fields, const char* name) {
  const LocatedText text = fields.Text(name);
  const auto moment = ParseMoment(text.text);
  if (moment) return *moment;
  if (!text.text.empty()) fields.Error(text.where, moment.problem());
  return Time{};
}

void ReadCalendar(YamlFields fields, Scenario& scenario) {
  const Interval span{ReadMoment(fields, "start"), ReadMoment(fields, "end")};
  const LocatedText hours = fields.Text("hours");
  fields.Finish();
  if (hours.text.empty() || span.to == Time{}) return;
  auto calendar = Calendar::Make(span, hours.text);
  if (!calendar) {
    fields.Error(hours.where, calendar.problem());
    return;
  }
  scenario.calendar = *std::move(calendar);
}

void ReadPeople(YamlFields fields, Scenario& scenario) {
  scenario.people_by_hour.assign(24, 0);
  for (int hour = 0; hour < 24; ++hour) {
    scenario.people_by_hour[static_cast<std::size_t>(hour)] =
        fields.Number(std::to_string(hour), 0, 0, 1000);
  }
  fields.Text("source");
  fields.Finish();
}

}  // namespace

const char* ToString(Fault fault) { return kNames[static_cast<std::size_t>(fault)]; }

Scenario LoadScenario(const std::string& path, Diagnostics& diagnostics) {
  Scenario scenario;
  YamlFields file = YamlFields::Load(path, diagnostics);
  ReadCalendar(file.Map("calendar"), scenario);
  ReadPeople(file.Map("people_by_hour"), scenario);
  YamlFields faults = file.Map("faults");
  for (std::size_t i = 0; i < kFaults; ++i) {
    scenario.rates[i] = ReadNumber(faults, kNames[i], 0, 1e6, scenario);
  }
  faults.Finish();
  YamlFields numbers = file.Map("numbers");
  for (const Entry& entry : kEntries) {
    scenario.*entry.value = ReadNumber(numbers, entry.name, entry.low, entry.high, scenario);
  }
  numbers.Finish();
  file.Finish();
  return scenario;
}

Outcome Without(const std::string& fault, Scenario& scenario) {
  const std::vector<std::string> names(kNames.begin(), kNames.end());
  const auto found = std::find(names.begin(), names.end(), fault);
  if (found == names.end()) {
    return Problem{"there is no fault \"" + fault + "\" " + DidYouMean(fault, names)};
  }
  scenario.rates[static_cast<std::size_t>(found - names.begin())] = 0;
  return {};
}

void MultiplyFaults(double factor, Scenario& scenario) {
  for (double& rate : scenario.rates) rate *= factor;
  for (const Fault fault : {Fault::kDocking, Fault::kNoCurrent}) {
    double& share = scenario.rates[static_cast<std::size_t>(fault)];
    share = std::min(share, 0.9);
  }
}

Outcome Shorten(int days, Scenario& scenario) {
  const Interval span = scenario.calendar.span();
  const Time end = DayAt(span.from).from + std::chrono::hours(24) * days;
  auto calendar = Calendar::Cut(scenario.calendar, std::min(span.to, end));
  if (!calendar) return Problem{calendar.problem()};
  scenario.calendar = *std::move(calendar);
  return {};
}

}  // namespace coppice::robot::deployment
