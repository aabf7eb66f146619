#include "robot_app/common/places/topological_map.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>

#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using testing::HasSubstr;

std::string Write(const std::string& text) {
  const std::string path =
      testing::TempDir() + testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml";
  std::ofstream(path) << text;
  return path;
}

std::string ErrorsOf(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(TopologicalMap::Load(Write(text), diagnostics));
  return diagnostics.ToString();
}

TopologicalMap Shipped() {
  Diagnostics diagnostics;
  auto map = TopologicalMap::Load(SourceFolder() + "/robot_app/config/sites/institute/places.yaml",
                                  diagnostics);
  EXPECT_TRUE(map) << diagnostics.ToString();
  return map.value_or(TopologicalMap());
}

TEST(TopologicalMap, LoadsTheShippedFile) {
  const TopologicalMap map = Shipped();
  ASSERT_GE(map.Find("hall"), 0);
  EXPECT_DOUBLE_EQ(map.places()[map.Find("hall")].pose->x, 46);
  EXPECT_EQ(map.site(), "institute");
  EXPECT_EQ(map.Find("nowhere"), -1);
}

TEST(TopologicalMap, FindsTheNearestPlace) {
  const TopologicalMap map = Shipped();
  EXPECT_EQ(map.places()[map.Nearest({37, 0.5, 0})].name, "corridor_east");
  EXPECT_EQ(map.places()[map.Nearest({-2.3, 0, 0})].name, "charging_station");
}

TEST(TopologicalMap, ChoosesEveryPatrolPlaceButNeverTheLastOne) {
  const TopologicalMap map = Shipped();
  std::mt19937 random(1);
  std::map<int, int> count;
  int last = -1;
  for (int i = 0; i < 800; ++i) {
    const int next = map.ChooseNext(random, last);
    ASSERT_NE(next, last);
    EXPECT_TRUE(map.places()[next].Is("patrol"));
    ++count[next];
    last = next;
  }
  EXPECT_EQ(count.size(), 8u);
  for (const auto& [place, times] : count) EXPECT_NEAR(times, 100, 40) << place;
}

TEST(TopologicalMap, TheSameSeedGivesTheSamePatrol) {
  const TopologicalMap map = Shipped();
  std::mt19937 a(7);
  std::mt19937 b(7);
  int last = -1;
  for (int i = 0; i < 20; ++i) {
    const int next = map.ChooseNext(a, last);
    EXPECT_EQ(map.ChooseNext(b, last), next);
    last = next;
  }
}

TEST(TopologicalMap, TheOnlyPlaceOfACategoryIsChosenAgain) {
  const TopologicalMap map = Shipped();
  std::mt19937 random(1);
  const int station = map.Find("charging_station");
  EXPECT_EQ(map.ChooseNext(random, station, "station"), station);
  EXPECT_EQ(map.ChooseNext(random, -1, "pool"), -1);
}

TEST(TopologicalMap, NamesTheLineOfEveryMistake) {
  const std::string errors = ErrorsOf(
      "places:\n"
      "  - {name: hall, x: 1, y: 2}\n"
      "  - {name: hall, x: 1, y: 2}\n"
      "  - {name: door, x: here, y: 2}\n"
      "  - {name: room, x: 1, y: 2, jaw: 3}\n"
      "  - {name: lift, x: 1}\n"
      "  - {name: two words, x: 1, y: 2}\n"
      "  - {name: round, categories: [patrol]}\n"
      "  - {name: cellar, called: {english: cellar}}\n"
      "edges:\n"
      "  - {from: hall, to: dor}\n"
      "  - {from: hall, to: door, by: fly}\n"
      "  - {from: hall, to: room, by: dock, both_ways: true}\n"
      "  - {from: hall, to: cellar}\n"
      "  - {from: room, to: cellar, by: elsewhere}\n"
      "  - {from: hall, to: room}\n");
  for (const char* const expected : {".yaml:3",
                                     "\"hall\" is already taken",
                                     ".yaml:4",
                                     ".yaml:5",
                                     "jaw",
                                     ".yaml:6",
                                     "missing key \"y\"",
                                     ".yaml:7",
                                     "\"two words\" is no name of a place",
                                     ".yaml:8",
                                     "a place of the category \"patrol\" needs x and y",
                                     ".yaml:9",
                                     "\"english\" is no language",
                                     ".yaml:11",
                                     "did you mean \"door\"?",
                                     ".yaml:12",
                                     "fly",
                                     ".yaml:13",
                                     "only an edge by drive or door goes both ways",
                                     ".yaml:14",
                                     "\"cellar\" has no position",
                                     ".yaml:15",
                                     "needs words",
                                     ".yaml:16",
                                     "already an edge hall -> room"}) {
    EXPECT_THAT(errors, HasSubstr(expected));
  }
}

// Advice on each would take half a minute.
TEST(TopologicalMap, OfVeryManyUnknownPlacesOnlyTheFirstGetAdvice) {
  const std::string end(40, 'x');
  std::string text = "places:\n", edges = "edges:\n";
  for (int i = 1000; i < 2000; ++i) {
    text += " - {name: p" + std::to_string(i) + end + ", x: 1, y: 1}\n";
    edges += " - {from: q" + std::to_string(i) + end + ", to: r" + std::to_string(i) + end + "}\n";
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(TopologicalMap::Load(Write(text + edges), diagnostics));
  const auto advised = std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                                     [](const Diagnostic& error) { return !error.hint.empty(); });
  EXPECT_GT(advised, 100);
  EXPECT_LT(advised, 1000);
}

TEST(TopologicalMap, MorePlacesOrEdgesThanATreeCanSearchAreAnError) {
  std::string text = "places:\n";
  for (int i = 0; i < 1001; ++i) text += " - {name: p" + std::to_string(i) + ", x: 1, y: 1}\n";
  EXPECT_THAT(ErrorsOf(text), HasSubstr(":1002:4: error: more than 1000 places"));
  text = "places: [{name: a, x: 1, y: 1}, {name: b, x: 2, y: 1}]\nedges:\n";
  for (int i = 0; i < 4001; ++i) text += " - {from: a, to: b}\n";
  EXPECT_THAT(ErrorsOf(text), HasSubstr("more than 4000 edges"));
}

TEST(TopologicalMap, AFileThatIsMissingOrEmptyIsAnError) {
  Diagnostics diagnostics;
  EXPECT_FALSE(TopologicalMap::Load("/no/such/file.yaml", diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("/no/such/file.yaml"));
  EXPECT_THAT(ErrorsOf("places: []\n"), HasSubstr("no places"));
}

TEST(TopologicalMap, APlaceIsCalledAsPeopleOfEachLanguageCallIt) {
  Diagnostics diagnostics;
  const auto map = TopologicalMap::Load(
      Write("places:\n"
            "  - {name: foyer, x: 0, y: 0, called: {en: [entrance hall, lobby], de: Halle}}\n"
            "  - {name: corridor_west, x: 1, y: 0}\n"),
      diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  EXPECT_EQ(map->places()[0].Spoken("en"), "entrance hall");
  EXPECT_EQ(map->places()[0].Spoken("de"), "Halle");
  EXPECT_EQ(map->places()[0].Spoken("fr"), "entrance hall");
  EXPECT_EQ(map->places()[1].Spoken("en"), "corridor west");
}

TEST(TopologicalMap, APlaceWithoutPositionIsNeverTheNearestNorOnAPatrol) {
  Diagnostics diagnostics;
  const auto map = TopologicalMap::Load(Write("places:\n"
                                              "  - {name: upstairs, categories: [room]}\n"
                                              "  - {name: hall, x: 9, y: 9}\n"),
                                        diagnostics);
  ASSERT_TRUE(map) << diagnostics.ToString();
  EXPECT_EQ(map->Nearest({0, 0, 0}), 1);
  std::mt19937 random(1);
  EXPECT_EQ(map->ChooseNext(random, -1, "room"), -1);
}

}  // namespace
}  // namespace coppice::robot
