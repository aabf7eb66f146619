#include "robot_app/knowledge/import/gtfs_feed.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <unordered_map>

#include "robot_app/knowledge/import/stop_times.h"
#include "robot_app/knowledge/import/zip_archive.h"

namespace coppice::robot::knowledge {
namespace {

constexpr const char* kWeekdays[] = {"monday", "tuesday",  "wednesday", "thursday",
                                     "friday", "saturday", "sunday"};

// One zip. Services and trips get its name before their ids: other feeds may have the same ones.
class Feed {
 public:
  Feed(const ZipArchive& archive, const std::string& name, const SiteIds& ids,
       Diagnostics& diagnostics)
      : archive_(archive), prefix_(name + ":"), ids_(ids), diagnostics_(diagnostics) {}

  void Read(Campus& campus) {
    ReadStops();
    ReadRoutes();
    ReadCalendar();
    ReadCalendarDates();
    ReadTrips();
    if (diagnostics_.has_errors()) return;
    StopTimes times(archive_, stops_, boarding_, trips_, diagnostics_);
    times.Read();
    if (diagnostics_.has_errors()) return;
    Keep(times, campus);
  }

  bool HasStop(const std::string& id) const { return stops_.count(id) > 0; }

 private:
  void ReadTable(const std::string& name, std::vector<CsvColumn> columns,
                 const std::function<void(CsvRow&)>& use) {
    const auto bytes = archive_.Read(name, diagnostics_);
    if (!bytes) return;
    ReadCsv(archive_.NameOf(name), *bytes, {std::move(columns), true}, diagnostics_, use);
  }

  // A stop of the site is one that a place names, or a platform of a station that it names.
  void ReadStops() {
    std::map<std::string, std::string> place_of;
    for (const StopOfPlace& stop : ids_.stops) place_of[stop.stop.text] = stop.place;
    ReadTable("stops.txt", {{"stop_id", true}, {"stop_name"}, {"parent_station"}},
              [&](CsvRow& row) {
                const std::string& id = row.fields[0];
                auto place = place_of.find(id);
                if (place == place_of.end()) place = place_of.find(row.fields[2]);
                if (place != place_of.end()) boarding_[id] = place->second;
                stops_[id] = row.fields[1];
              });
  }

  void ReadRoutes() {
    ReadTable("routes.txt", {{"route_id", true}, {"route_short_name"}, {"route_long_name"}},
              [&](CsvRow& row) {
                const std::string& line = row.fields[row.fields[1].empty() ? 2 : 1];
                lines_[row.fields[0]] = line;
                if (line.empty()) {
                  diagnostics_.Error(row.where, "expected a route_short_name or route_long_name");
                }
              });
  }

  std::optional<Day> ReadDay(const std::string& text, const SourceLocation& where) {
    const std::optional<Day> day = ParseDay(text);
    if (!day) diagnostics_.Error(where, "expected a day as YYYYMMDD, not \"" + text + "\"");
    return day;
  }

  void ReadCalendar() {
    if (!archive_.Has("calendar.txt")) return;
    std::vector<CsvColumn> columns = {
        {"service_id", true}, {"start_date", true}, {"end_date", true}};
    for (const char* weekday : kWeekdays) columns.push_back({weekday, true});
    ReadTable("calendar.txt", columns, [&](CsvRow& row) {
      const auto first = ReadDay(row.fields[1], row.where),
                 last = ReadDay(row.fields[2], row.where);
      if (!first || !last) return;
      Service service{prefix_ + row.fields[0], *first, *last, 0};
      for (int day = 0; day < 7; ++day) {
        const std::string& runs = row.fields[static_cast<std::size_t>(3 + day)];
        if (runs == "1") service.weekdays |= static_cast<std::uint8_t>(1U << day);
        if (runs != "1" && runs != "0") {
          diagnostics_.Error(
              row.where, std::string(kWeekdays[day]) + ": expected 0 or 1, not \"" + runs + "\"");
        }
      }
      services_[service.id] = service;
    });
  }

  void ReadCalendarDates() {
    if (!archive_.Has("calendar_dates.txt")) {
      if (!archive_.Has("calendar.txt")) {
        diagnostics_.Error({archive_.NameOf(""), 0, 0},
                           "expected calendar.txt or calendar_dates.txt in it");
      }
      return;
    }
    ReadTable("calendar_dates.txt",
              {{"service_id", true}, {"date", true}, {"exception_type", true}}, [&](CsvRow& row) {
                const auto day = ReadDay(row.fields[1], row.where);
                const std::string& type = row.fields[2];
                if (type != "1" && type != "2") {
                  diagnostics_.Error(row.where,
                                     "exception_type: expected 1 or 2, not \"" + type + "\"");
                } else if (day) {
                  const std::string service = prefix_ + row.fields[0];
                  exceptions_.push_back({service, *day, type == "1"});
                  services_.emplace(service, Service{service, {}, {-1}, 0});
                }
              });
  }

  void ReadTrips() {
    ReadTable(
        "trips.txt",
        {{"trip_id", true}, {"route_id", true}, {"service_id", true}, {"trip_headsign"}},
        [&](CsvRow& row) {
          const auto line = lines_.find(row.fields[1]);
          const std::string service = prefix_ + row.fields[2];
          if (line == lines_.end()) {
            diagnostics_.Error(row.where, "routes.txt has no route \"" + row.fields[1] + "\"");
          } else if (services_.count(service) == 0) {
            diagnostics_.Error(row.where, "no calendar has the service \"" + row.fields[2] + "\"");
          } else if (!trips_
                          .emplace(row.fields[0], Trip{prefix_ + row.fields[0], service,
                                                       line->second, row.fields[3]})
                          .second) {
            diagnostics_.Error(row.where, "a second trip \"" + row.fields[0] + "\"");
          }
        });
  }

  void Keep(StopTimes& times, Campus& campus) {
    std::set<std::string> services, stops, lines;
    for (Trip& trip : times.trips) {
      services.insert(trip.service);
      lines.insert(trip.line);
      campus.trips.push_back(std::move(trip));
    }
    for (Call& call : times.calls) {
      stops.insert(call.stop);
      campus.calls.push_back(std::move(call));
    }
    for (const std::string& service : services) campus.services.push_back(services_[service]);
    for (const ServiceException& exception : exceptions_) {
      if (services.count(exception.service) > 0) campus.exceptions.push_back(exception);
    }
    for (const std::string& stop : stops) campus.stops.push_back({stop, stops_[stop]});
    for (const auto& [stop, place] : boarding_) {
      if (stops.count(stop) > 0) campus.boardings.push_back({stop, place});
    }
    for (const Language language : kLanguages) {
      for (const std::string& line : lines) {
        campus.names.push_back({Kind::kLine, line, language, line, true});
      }
      for (const std::string& stop : stops) {
        const std::string& name = stops_[stop];
        campus.names.push_back({Kind::kStop, name, language, name, true});
      }
    }
  }

  const ZipArchive& archive_;
  std::string prefix_;
  const SiteIds& ids_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::string> boarding_;                 // stop -> place
  std::unordered_map<std::string, std::string> stops_, lines_;  // id -> name
  std::map<std::string, Service> services_;
  std::vector<ServiceException> exceptions_;
  std::unordered_map<std::string, Trip> trips_;  // by the feed's id
};

}  // namespace

void ReadFeeds(const std::vector<std::string>& feeds, Campus& campus, const SiteIds& ids,
               Diagnostics& diagnostics) {
  std::set<std::string> found;
  for (const std::string& path : feeds) {
    const auto archive = ZipArchive::Open(path, diagnostics);
    if (!archive) return;
    Diagnostics of_feed;
    Feed feed(*archive, std::filesystem::path(path).stem(), ids, of_feed);
    feed.Read(campus);
    diagnostics.Append(of_feed);
    for (const StopOfPlace& stop : ids.stops) {
      if (feed.HasStop(stop.stop.text)) found.insert(stop.stop.text);
    }
  }
  for (const StopOfPlace& stop : ids.stops) {
    if (found.count(stop.stop.text) == 0) {
      diagnostics.Error(stop.stop.where, "no timetable has a stop \"" + stop.stop.text + "\"");
    }
  }
}

}  // namespace coppice::robot::knowledge
