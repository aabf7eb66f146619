#include "robot_app/knowledge/import/stop_times.h"

#include <algorithm>
#include <charconv>

#include "robot_app/knowledge/import/gtfs_feed.h"

namespace coppice::robot::knowledge {
namespace {

using std::chrono::seconds;

constexpr seconds kNoTime{-1};  // not a timepoint: to be filled in
constexpr seconds kLongestDay = std::chrono::hours(96);
constexpr char kNotRegular = '1';  // pickup_type: nobody gets in

std::optional<int> ParseWhole(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

// Evenly between the timepoints before and behind.
void FillTimes(std::vector<Call>& calls) {
  std::size_t before = 0;
  for (std::size_t i = 1; i < calls.size(); ++i) {
    if (calls[i].departure == kNoTime) continue;
    const auto gaps = static_cast<std::int64_t>(i - before);
    for (std::size_t between = before + 1; between < i; ++between) {
      calls[between].departure =
          calls[before].departure + (calls[i].departure - calls[before].departure) *
                                        static_cast<std::int64_t>(between - before) / gaps;
    }
    before = i;
  }
}

}  // namespace

std::optional<seconds> ParseGtfsTime(std::string_view text) {
  const std::size_t minutes = text.find(':');
  if (minutes == 0 || minutes > 2 || text.size() != minutes + 6 || text[minutes + 3] != ':') {
    return std::nullopt;
  }
  const auto h = ParseWhole(text.substr(0, minutes)), m = ParseWhole(text.substr(minutes + 1, 2)),
             s = ParseWhole(text.substr(minutes + 4));
  if (!h || !m || !s || *m > 59 || *s > 59) return std::nullopt;
  const seconds time = std::chrono::hours(*h) + std::chrono::minutes(*m) + seconds(*s);
  return time > kLongestDay ? std::nullopt : std::optional(time);
}

void StopTimes::Read() {
  FindTrips();
  ReadCalls();
  ReadFrequencies();
  for (auto& [id, of_trip] : by_trip_) AddTrip(id, of_trip);
}

void StopTimes::FindTrips() {
  const auto bytes = archive_.Read("stop_times.txt", diagnostics_);
  if (!bytes) return;
  ReadCsv(archive_.NameOf("stop_times.txt"), *bytes, {{{"trip_id", true}, {"stop_id", true}}, true},
          diagnostics_, [this](CsvRow& row) {
            if (all_trips_.count(row.fields[0]) == 0) {
              diagnostics_.Error(row.where, "trips.txt has no trip \"" + row.fields[0] + "\"");
            } else if (stops_.count(row.fields[1]) == 0) {
              diagnostics_.Error(row.where, "stops.txt has no stop \"" + row.fields[1] + "\"");
            } else if (boarding_.count(row.fields[1]) > 0) {
              wanted_.insert(row.fields[0]);
            }
          });
}

void StopTimes::ReadCalls() {
  if (diagnostics_.has_errors()) return;
  const auto bytes = archive_.Read("stop_times.txt", diagnostics_);
  if (!bytes) return;
  std::size_t count = 0;
  ReadCsv(archive_.NameOf("stop_times.txt"), *bytes,
          {{{"trip_id", true},
            {"stop_id", true},
            {"stop_sequence", true},
            {"departure_time"},
            {"arrival_time"},
            {"pickup_type"}},
           true},
          diagnostics_, [&](CsvRow& row) {
            if (wanted_.count(row.fields[0]) == 0 || ++count > kMostCalls) return;
            ReadCall(row);
          });
  if (count > kMostCalls) ReportTooMany();
}

void StopTimes::ReportTooMany() {
  diagnostics_.Error(
      {archive_.NameOf("stop_times.txt"), 0, 0},
      "expected at most " + std::to_string(kMostCalls) + " calls of trips that come to the site");
}

void StopTimes::ReadCall(const CsvRow& row) {
  const std::string& text = row.fields[3].empty() ? row.fields[4] : row.fields[3];
  const auto time = text.empty() ? std::optional(kNoTime) : ParseGtfsTime(text);
  const auto sequence = ParseWhole(row.fields[2]);
  if (!time) {
    diagnostics_.Error(row.where, "expected a time as H:MM:SS, not \"" + text + "\"");
  } else if (!sequence) {
    diagnostics_.Error(row.where,
                       "stop_sequence: expected a whole number, not \"" + row.fields[2] + "\"");
  } else {
    const bool boards = row.fields[5].empty() || row.fields[5][0] != kNotRegular;
    by_trip_[row.fields[0]].push_back(
        {all_trips_.at(row.fields[0]).id, row.fields[1], *sequence, *time, boards});
  }
}

void StopTimes::ReadFrequencies() {
  if (!archive_.Has("frequencies.txt")) return;
  const auto bytes = archive_.Read("frequencies.txt", diagnostics_);
  if (!bytes) return;
  ReadCsv(
      archive_.NameOf("frequencies.txt"), *bytes,
      {{{"trip_id", true}, {"start_time", true}, {"end_time", true}, {"headway_secs", true}}, true},
      diagnostics_, [this](CsvRow& row) {
        const auto first = ParseGtfsTime(row.fields[1]), end = ParseGtfsTime(row.fields[2]);
        const auto headway = ParseWhole(row.fields[3]);
        if (!first || !end || !headway || *headway < 1) {
          diagnostics_.Error(row.where, "expected times as H:MM:SS and headway_secs above 0");
        } else {
          frequencies_[row.fields[0]].push_back({*first, *end, seconds(*headway)});
        }
      });
}

void StopTimes::AddTrip(const std::string& id, std::vector<Call>& of_trip) {
  std::sort(of_trip.begin(), of_trip.end(),
            [](const Call& a, const Call& b) { return a.sequence < b.sequence; });
  of_trip.back().boards = false;  // there it ends
  if (of_trip.front().departure == kNoTime || of_trip.back().departure == kNoTime) {
    diagnostics_.Error({archive_.NameOf("stop_times.txt"), 0, 0},
                       "trip \"" + id + "\": expected a time at its first and last stop");
    return;
  }
  FillTimes(of_trip);
  Trip kept = all_trips_.at(id);
  if (kept.headsign.empty()) kept.headsign = stops_.at(of_trip.back().stop);
  const auto frequencies = frequencies_.find(id);
  if (frequencies == frequencies_.end()) {
    trips.push_back(kept);
    calls.insert(calls.end(), of_trip.begin(), of_trip.end());
    return;
  }
  for (const Frequency& frequency : frequencies->second) Repeat(kept, of_trip, frequency);
}

// The times of the trip itself are no matter then, only how long it takes.
void StopTimes::Repeat(const Trip& trip, const std::vector<Call>& of_trip,
                       const Frequency& frequency) {
  for (seconds start = frequency.first; start < frequency.end; start += frequency.headway) {
    if (calls.size() > kMostCalls) return ReportTooMany();
    Trip one = trip;
    one.id += "#" + std::to_string(start.count());
    for (Call call : of_trip) {
      call.departure += start - of_trip.front().departure;
      call.trip = one.id;
      calls.push_back(std::move(call));
    }
    trips.push_back(std::move(one));
  }
}

}  // namespace coppice::robot::knowledge
