#include "robot_app/knowledge/import/read_campus.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>

#include "tests/robot_app/knowledge/sample_database.h"

namespace coppice::robot::knowledge {
namespace {

using testing::HasSubstr;

// The sample with a file or a part of it changed.
class ReadCampusTest : public testing::Test {
 protected:
  ReadCampusTest() {
    std::filesystem::copy(SampleFolder(), folder_.path(), std::filesystem::copy_options::recursive);
  }
  void Replace(const std::string& file, const std::string& from, const std::string& to) {
    std::string text = coppice::ReadFile(folder_.Path(file));
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    coppice::WriteFile(folder_.Path(file), text.replace(at, from.size(), to));
  }
  std::string Problems() {
    Diagnostics diagnostics;
    ReadCampus(folder_.path(), diagnostics);
    return diagnostics.ToString();
  }
  TemporaryFolder folder_;
};

TEST_F(ReadCampusTest, TheSampleIsWithoutFault) { EXPECT_EQ(Problems(), ""); }

TEST_F(ReadCampusTest, EverythingWrongIsSaidAtOnce) {
  Replace("staff.csv", "office_101", "ofice_101");
  Replace("campus.yaml", "Europe/Berlin", "Europe/Erlenhof");
  Replace("campus.yaml", "home: hall", "home: hell");
  Replace("campus.yaml", "Mo-Fr 07:00-19:00", "7 to 7");
  Replace("menus/canteen.en.json", "2026-11-23", "yesterday");
  const std::string problems = Problems();
  EXPECT_THAT(problems,
              HasSubstr("staff.csv:2: error: there is no place \"ofice_101\" (did you mean "
                        "\"office_101\"?)"));
  EXPECT_THAT(problems, HasSubstr("\"Europe/Erlenhof\" is no time zone"));
  EXPECT_THAT(problems, HasSubstr("there is no place \"hell\" (did you mean \"hall\"?)"));
  EXPECT_THAT(problems, HasSubstr("are no opening hours, such as"));
  EXPECT_THAT(problems, HasSubstr("expected a date such as 2026-11-25, not yesterday"));
}

// Advice on each would take a minute with as many people as there may be.
TEST_F(ReadCampusTest, OfVeryManyUnknownPlacesOnlyTheFirstGetAdvice) {
  const std::string end(40, 'x');
  std::string places, staff;
  for (int i = 1000; i < 1900; ++i) {
    const std::string number = std::to_string(i);
    places += "  - {name: p" + number + end + ", x: 1, y: 1, called: {en: p" + number + ", de: p" +
              number + "}}\n";
    for (const char* const wrong : {"q", "r"}) {
      staff += wrong + number + ",Weber,," + wrong + number + end + ",,,,,\n";
    }
  }
  Replace("places.yaml", "\nedges:", "\n" + places + "edges:");
  Replace("staff.csv", "Anna,Weber", staff + "Anna,Weber");
  Diagnostics diagnostics;
  ReadCampus(folder_.path(), diagnostics);
  const auto advised = std::count_if(diagnostics.all().begin(), diagnostics.all().end(),
                                     [](const Diagnostic& error) { return !error.hint.empty(); });
  EXPECT_EQ(diagnostics.all().size(), 1800U);
  EXPECT_GT(advised, 100);
  EXPECT_LT(advised, 1000);
}

TEST_F(ReadCampusTest, AWrongFieldIsSaidWithItsLine) {
  Replace("campus.yaml", "time_zone", "timezone");
  EXPECT_THAT(Problems(),
              HasSubstr("campus.yaml:3:3: error: unknown key \"timezone\" (did you mean "
                        "\"time_zone\"?)"));
}

TEST_F(ReadCampusTest, AMenuOfNoCanteenIsAnError) {
  std::filesystem::rename(folder_.Path("menus/canteen.en.json"),
                          folder_.Path("menus/mensa.en.json"));
  EXPECT_THAT(Problems(), HasSubstr("mensa.en.json: error: there is no place \"mensa\""));
  std::filesystem::rename(folder_.Path("menus/mensa.en.json"), folder_.Path("menus/canteen.json"));
  EXPECT_THAT(Problems(), HasSubstr("expected a name such as canteen.en.json"));
}

TEST_F(ReadCampusTest, AMenuOfAnotherShapeIsAnErrorWithItsPlace) {
  coppice::WriteFile(folder_.Path("menus/canteen.en.json"),
                     "[{\"date\": \"2026-11-25\",\n \"meals\": [{\"name\": 3}, 4]}, 5]");
  const std::string problems = Problems();
  EXPECT_THAT(problems, HasSubstr("canteen.en.json:2:21: error: expected a text"));
  EXPECT_THAT(problems, HasSubstr("expected a meal"));
  EXPECT_THAT(problems, HasSubstr("expected a day"));
}

TEST_F(ReadCampusTest, TwoPeopleOfOneNameNeedIds) {
  Replace("staff.csv", "Jonas,Becker,,office_204,", "Li,Wang,,office_204,");
  EXPECT_THAT(Problems(), HasSubstr("a second person \"li_wang\"; the first is in"));
}

TEST_F(ReadCampusTest, SmallTalkNeedsAllLanguages) {
  Replace("small_talk.yaml", "de: [hallo,", "fr: [salut,");
  EXPECT_THAT(Problems(), HasSubstr("expected what people say in de"));
}

TEST_F(ReadCampusTest, AFileThatNobodyReadsIsAWarning) {
  coppice::WriteFile(folder_.Path("stuff.csv"), "");
  EXPECT_THAT(Problems(), HasSubstr("stuff.csv: warning: nobody reads this file (did you mean "
                                    "\"staff.csv\"?)"));
}

TEST_F(ReadCampusTest, PlacesAloneAreEnough) {
  for (const char* file : {"staff.csv", "small_talk.yaml", "menus"}) {
    std::filesystem::remove_all(folder_.Path(file));
  }
  EXPECT_EQ(Problems(), "");
}

TEST_F(ReadCampusTest, AFolderWithoutPlacesIsAnError) {
  std::filesystem::remove(folder_.Path("places.yaml"));
  EXPECT_THAT(Problems(), HasSubstr("places.yaml: error: "));
  Diagnostics diagnostics;
  ReadCampus(folder_.Path("missing"), diagnostics);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("expected a folder"));
}

}  // namespace
}  // namespace coppice::robot::knowledge
