#include "robot_app/knowledge/store/queries.h"

#include <gmock/gmock.h>

#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class Queries : public testing::Test {
 protected:
  // "07:56 4 Hauptbahnhof"
  std::vector<std::string> Next(WallTime now, const DepartureFilter& filter, int most) {
    std::vector<std::string> texts;
    for (const Departure& one : NextDepartures(*sample_, sample_.time(), now, filter, most)) {
      const LocalTime local = sample_.time().Local(one.when);
      texts.push_back(ClockText(local.time) + " " + one.line + " " + one.headsign);
    }
    return texts;
  }
  std::vector<std::string> Ids(const std::vector<Place>& places) {
    std::vector<std::string> ids;
    for (const Place& place : places) ids.push_back(place.id);
    return ids;
  }
  std::vector<std::string> Meals(const std::string& diet, Language language) {
    std::vector<std::string> names;
    for (const MenuOfDay& menu : MenusOn(*sample_, *ParseDay("2026-11-25"), diet, language)) {
      for (const Meal& meal : menu.meals) names.push_back(meal.name);
    }
    return names;
  }

  SampleDatabase sample_;
};

TEST_F(Queries, TheNextDeparturesComeInTheirOrder) {
  EXPECT_THAT(Next(sample_.At("2026-11-25", 8), {}, 4),
              ElementsAre("08:00 120 Flughafen", "08:00 S3 Flughafen", "08:04 120 Flughafen",
                          "08:06 4 Hauptbahnhof"));
}

TEST_F(Queries, ADepartureAtThisVerySecondIsNotMissed) {
  EXPECT_EQ(Next(sample_.At("2026-11-25", 8, 6), {"4", "", ""}, 1)[0], "08:06 4 Hauptbahnhof");
}

TEST_F(Queries, TripsAfterMidnightBelongToTheDayBefore) {
  // Night buses run in the nights after Friday and Saturday.
  EXPECT_THAT(Next(sample_.At("2026-11-28", 0, 10), {"N4", "", ""}, 1),
              ElementsAre("00:43 N4 Erlensee"));
  EXPECT_EQ(NextDepartures(*sample_, sample_.time(), sample_.At("2026-11-24", 0), {"N4", "", ""}, 1)
                .at(0)
                .when,
            sample_.At("2026-11-28", 0, 43));
}

TEST_F(Queries, AHolidayRunsLikeASunday) {
  const auto of_friday = Next(sample_.At("2026-12-18", 8), {"4", "Hauptbahnhof", ""}, 3);
  const auto of_holiday = Next(sample_.At("2026-12-25", 8), {"4", "Hauptbahnhof", ""}, 3);
  EXPECT_THAT(of_friday,
              ElementsAre("08:06 4 Hauptbahnhof", "08:16 4 Hauptbahnhof", "08:26 4 Hauptbahnhof"));
  EXPECT_THAT(of_holiday,
              ElementsAre("08:06 4 Hauptbahnhof", "08:26 4 Hauptbahnhof", "08:46 4 Hauptbahnhof"));
}

TEST_F(Queries, OnlyTripsThatStillComeToTheStopCount) {
  EXPECT_THAT(Next(sample_.At("2026-11-25", 8), {"", "Flughafen", ""}, 2),
              ElementsAre("08:00 120 Flughafen", "08:00 S3 Flughafen"));
  EXPECT_THAT(Next(sample_.At("2026-11-25", 8), {"4", "Flughafen", ""}, 2), IsEmpty());
}

TEST_F(Queries, APlaceToGetInMayBeGiven) {
  for (const Departure& one : NextDepartures(*sample_, sample_.time(), sample_.At("2026-11-25", 8),
                                             {"", "", "stop_park"}, 5)) {
    EXPECT_EQ(one.place, "stop_park");
  }
}

TEST_F(Queries, NobodyGetsInWhereATripEnds) {
  for (const std::string& text : Next(sample_.At("2026-11-25", 8), {"", "", "stop_park"}, 20)) {
    EXPECT_EQ(text.find("Technologiepark"), std::string::npos) << text;
  }
}

TEST_F(Queries, AMenuCanBeOfADiet) {
  EXPECT_THAT(
      Meals("", Language::kEnglish),
      ElementsAre("Fried fish with potato salad", "Cheese dumplings with spinach", "Pumpkin soup"));
  EXPECT_THAT(Meals("vegetarian", Language::kGerman),
              ElementsAre("Käseknödel mit Spinat", "Kürbissuppe"));
  EXPECT_THAT(Meals("vegan", Language::kEnglish), ElementsAre("Pumpkin soup"));
}

TEST_F(Queries, ADayWithoutAMenuHasNone) {
  EXPECT_THAT(MenusOn(*sample_, *ParseDay("2027-06-01"), "", Language::kEnglish), IsEmpty());
  const auto sunday = MenusOn(*sample_, *ParseDay("2026-11-29"), "", Language::kEnglish);
  ASSERT_THAT(sunday, SizeIs(1));
  EXPECT_TRUE(sunday[0].is_closed);
}

TEST_F(Queries, TheNearestOfACategoryIsOnThisFloor) {
  const Position here{"institute", 0, Point{36, 0}};
  const auto way = [&here](const Place& place) { return StraightWay(here, place.position); };
  EXPECT_THAT(Ids(NearestPlaces(*sample_, "restroom", way)),
              ElementsAre("restroom_ground", "restroom_first"));
  const Position above{"institute", 1, std::nullopt};
  const auto way_above = [&above](const Place& place) {
    return StraightWay(above, place.position);
  };
  EXPECT_EQ(Ids(NearestPlaces(*sample_, "coffee", way_above))[0], "kitchen");
}

TEST_F(Queries, TheNearestMayBeMeasuredByTheRealWay) {
  const auto way = [](const Place& place) { return place.id == "restroom_first" ? 1.0 : 2.0; };
  EXPECT_EQ(Ids(NearestPlaces(*sample_, "restroom", way))[0], "restroom_first");
}

TEST_F(Queries, APersonHasAnOffice) {
  const auto person = FindPerson(*sample_, "anna_weber");
  ASSERT_TRUE(person);
  EXPECT_EQ(person->office, "office_101");
  EXPECT_EQ(NameOf(*sample_, Kind::kPerson, "anna_weber", Language::kGerman),
            "Prof. Dr. Anna Weber");
  EXPECT_EQ(PeopleIn(*sample_, "office_101").at(0).id, "anna_weber");
  EXPECT_FALSE(FindPerson(*sample_, "nobody"));
}

TEST_F(Queries, HolidaysAreKnown) {
  EXPECT_TRUE(IsHoliday(*sample_, *ParseDay("2026-12-25")));
  EXPECT_FALSE(IsHoliday(*sample_, *ParseDay("2026-11-25")));
}

TEST_F(Queries, TheWayToAPlaceElsewhereIsInWords) {
  const auto place = FindPlace(*sample_, "office_203");
  ASSERT_TRUE(place);
  EXPECT_EQ(place->position.floor, 1);
  EXPECT_EQ(In(Language::kEnglish, place->way),
            "Take the elevator or the stairs in the entrance hall to the first floor.");
}

}  // namespace
}  // namespace coppice::robot::knowledge
