#include "robot_app/knowledge/import/gtfs_feed.h"

#include <gmock/gmock.h>

#include "tests/robot_app/knowledge/import/zip_of.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::knowledge {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class GtfsFeed : public testing::Test {
 protected:
  Campus Read() {
    diagnostics_ = {};
    WriteZip(folder_.Path("feed.zip"), files_);
    return ReadFile(folder_.Path("feed.zip"));
  }
  Campus ReadFile(const std::string& path) {
    Campus campus;
    SiteIds ids;
    ids.stops.push_back({{"station", {"campus.yaml", 7, 1}}, "stop"});
    ReadFeeds({path}, campus, ids, diagnostics_);
    return campus;
  }
  // Line, seconds of the day and whether people may get in, of each call.
  std::vector<std::string> Calls() {
    std::vector<std::string> texts;
    for (const Call& call : Read().calls) {
      texts.push_back(call.trip + " " + call.stop + " " + std::to_string(call.departure.count()) +
                      (call.boards ? "" : " no entry"));
    }
    return texts;
  }
  std::string Problems() {
    Read();
    std::string text = diagnostics_.ToString();
    for (std::size_t at; (at = text.find(folder_.path() + "/")) != std::string::npos;) {
      text.erase(at, folder_.path().size() + 1);
    }
    return text;
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
  std::map<std::string, std::string> files_ = {
      {"stops.txt",
       "stop_id,stop_name,parent_station\nstation,Campus,\nplatform,Campus,station\n"
       "town,Town,\nelsewhere,Elsewhere,\n"},
      {"routes.txt", "route_id,route_short_name,route_long_name\nr1,4,\nr2,,Ring line\n"},
      {"calendar.txt",
       "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n"
       "daily,1,1,1,1,1,1,1,20260101,20261231\n"},
      {"trips.txt", "route_id,service_id,trip_id,trip_headsign\nr1,daily,t1,\nr2,daily,t2,Round\n"},
      {"stop_times.txt",
       "trip_id,arrival_time,departure_time,stop_id,stop_sequence\n"
       "t1,24:10:00,24:10:00,town,20\nt1,23:50:00,23:51:00,platform,3\n"
       "t2,8:00:00,8:00:00,town,1\nt2,8:05:00,8:05:00,elsewhere,2\n"}};
};

TEST_F(GtfsFeed, TripsThatCallAtTheSiteAreKeptWithAllOfTheirCallsInOrder) {
  EXPECT_THAT(Calls(), ElementsAre("feed:t1 platform 85860", "feed:t1 town 87000 no entry"));
  const Campus campus = Read();
  ASSERT_THAT(campus.trips, SizeIs(1));
  EXPECT_EQ(campus.trips[0].line, "4");
  EXPECT_EQ(campus.trips[0].headsign, "Town");
  ASSERT_THAT(campus.boardings, SizeIs(1));
  EXPECT_EQ(campus.boardings[0].stop, "platform");
  EXPECT_EQ(campus.boardings[0].place, "stop");
  EXPECT_EQ(Problems(), "");
}

TEST_F(GtfsFeed, TimesBetweenTimepointsAreFilledIn) {
  files_["stop_times.txt"] =
      "trip_id,arrival_time,departure_time,stop_id,stop_sequence,pickup_type\n"
      "t1,,08:00:00,platform,1,\nt1,,,elsewhere,2,1\nt1,,,town,3,0\nt1,08:09:00,,town,4,0\n";
  EXPECT_THAT(Calls(), ElementsAre("feed:t1 platform 28800", "feed:t1 elsewhere 28980 no entry",
                                   "feed:t1 town 29160", "feed:t1 town 29340 no entry"));
}

TEST_F(GtfsFeed, ATripMayBeRepeated) {
  files_["frequencies.txt"] =
      "trip_id,start_time,end_time,headway_secs\nt1,06:00:00,06:20:00,600\n";
  EXPECT_THAT(Calls(),
              ElementsAre("feed:t1#21600 platform 21600", "feed:t1#21600 town 22740 no entry",
                          "feed:t1#22200 platform 22200", "feed:t1#22200 town 23340 no entry"));
}

TEST_F(GtfsFeed, AServiceMayHaveNothingButExceptions) {
  files_.erase("calendar.txt");
  files_["calendar_dates.txt"] = "service_id,date,exception_type\ndaily,20261125,1\n";
  const Campus campus = Read();
  ASSERT_THAT(campus.services, SizeIs(1));
  EXPECT_EQ(campus.services[0].weekdays, 0);
  ASSERT_THAT(campus.exceptions, SizeIs(1));
  EXPECT_TRUE(campus.exceptions[0].runs);
}

TEST_F(GtfsFeed, WhatIsWrongIsSaidWithFileAndLine) {
  files_["stop_times.txt"] =
      "trip_id,departure_time,stop_id,stop_sequence\n"
      "t1,25:60:00,platform,1\nt1,late,town,2\nt1,08:00:00,town,-1\n";
  EXPECT_EQ(
      Problems(),
      "feed.zip/stop_times.txt:2: error: expected a time as H:MM:SS, not \"25:60:00\"\n"
      "feed.zip/stop_times.txt:3: error: expected a time as H:MM:SS, not \"late\"\n"
      "feed.zip/stop_times.txt:4: error: stop_sequence: expected a whole number, not \"-1\"\n");
}

TEST_F(GtfsFeed, TablesThatDoNotFitTogetherAreAnError) {
  files_["trips.txt"] = "route_id,service_id,trip_id\nr9,daily,t1\nr1,never,t2\n";
  EXPECT_EQ(Problems(),
            "feed.zip/trips.txt:2: error: routes.txt has no route \"r9\"\n"
            "feed.zip/trips.txt:3: error: no calendar has the service \"never\"\n");
  files_["trips.txt"] = "route_id,service_id,trip_id\nr1,daily,t1\n";
  EXPECT_THAT(Problems(), HasSubstr("stop_times.txt:4: error: trips.txt has no trip \"t2\""));
}

TEST_F(GtfsFeed, WrongDaysAndFlagsAreAnError) {
  files_["calendar.txt"] =
      "service_id,monday,tuesday,wednesday,thursday,friday,saturday,sunday,start_date,end_date\n"
      "daily,1,1,yes,1,1,1,1,20260230,20261231\nother,2,1,1,1,1,1,1,20260101,20261231\n";
  EXPECT_THAT(Problems(), HasSubstr("calendar.txt:2: error: expected a day as YYYYMMDD, not"));
  EXPECT_THAT(Problems(), HasSubstr("calendar.txt:3: error: monday: expected 0 or 1, not \"2\""));
}

TEST_F(GtfsFeed, AMissingTableIsAnError) {
  files_.erase("stops.txt");
  EXPECT_THAT(Problems(), HasSubstr("feed.zip: error: expected a file stops.txt in it"));
}

TEST_F(GtfsFeed, AStopThatNoTimetableHasIsAnErrorWhereItIsNamed) {
  files_["stops.txt"] = "stop_id,stop_name\nplatform,A\ntown,B\nelsewhere,C\n";
  EXPECT_THAT(Problems(), HasSubstr("campus.yaml:7:1: error: no timetable has a stop \"station\""));
}

TEST_F(GtfsFeed, WhatIsNoZipOrADamagedOneIsAnError) {
  Read();
  std::string bytes = coppice::ReadFile(folder_.Path("feed.zip"));
  for (const std::string& broken :
       {std::string("no zip"), bytes.substr(0, bytes.size() / 2), std::string()}) {
    coppice::WriteFile(folder_.Path("broken.zip"), broken);
    diagnostics_ = {};
    EXPECT_THAT(ReadFile(folder_.Path("broken.zip")).trips, IsEmpty());
    EXPECT_TRUE(diagnostics_.has_errors());
  }
}

TEST_F(GtfsFeed, NoByteOfAZipMakesItCrash) {
  Read();
  const std::string bytes = coppice::ReadFile(folder_.Path("feed.zip"));
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::string broken = bytes;
    broken[at] = static_cast<char>(~broken[at]);
    coppice::WriteFile(folder_.Path("broken.zip"), broken);
    diagnostics_ = {};
    ReadFile(folder_.Path("broken.zip"));
  }
}

TEST_F(GtfsFeed, ATimeHasHoursMinutesAndSeconds) {
  EXPECT_EQ(ParseGtfsTime("7:05:09")->count(), 25509);
  EXPECT_EQ(ParseGtfsTime("31:00:00")->count(), 111600);
  for (const char* wrong : {"", "7:5:09", "7:05", "-1:00:00", "07:60:00", "7:05:9x", "123:00:00"}) {
    EXPECT_FALSE(ParseGtfsTime(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace coppice::robot::knowledge
