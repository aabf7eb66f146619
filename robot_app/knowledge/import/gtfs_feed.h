// Timetables of public transport: GTFS Schedule (gtfs.org/documentation/schedule/reference), a zip
// as transport agencies publish it. Read are stops, routes, trips, stop_times, calendar,
// calendar_dates and frequencies. Kept are the trips that call at a stop of the site, with all of
// their calls; a feed of a whole country is read in two passes and takes memory for the ids of its
// trips.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_GTFS_FEED_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_GTFS_FEED_H_

#include <string>
#include <vector>

#include "robot_app/knowledge/import/site_files.h"

namespace coppice::robot::knowledge {

/// Adds stops, services, trips, calls and their names. A stop of a place that no feed has is an
/// error; `feeds` are the paths of all.
void ReadFeeds(const std::vector<std::string>& feeds, Campus& campus, const SiteIds& ids,
               Diagnostics& diagnostics);

/// "25:10:00" as seconds of the service's day; nothing if it is no time.
std::optional<std::chrono::seconds> ParseGtfsTime(std::string_view text);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_IMPORT_GTFS_FEED_H_
