#include "robot_app/deployment/run_seeds.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "robot_app/deployment/figures/journal_file.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::deployment {
namespace {

using testing::ElementsAre;

TEST(RunSeeds, ReadsSeedsAsPeopleWriteThem) {
  EXPECT_THAT(ParseSeeds("3").value(), ElementsAre(3));
  EXPECT_THAT(ParseSeeds("1-3,7").value(), ElementsAre(1, 2, 3, 7));
  EXPECT_THAT(ParseSeeds("18446744073709551615").value(), ElementsAre(UINT64_MAX));  // and ends
  for (const char* text : {"", "a", "3-1", "1-", "1,,2", "1-20000", "-1", "1x"}) {
    EXPECT_FALSE(ParseSeeds(text)) << text;
  }
}

class RunSeedsTest : public testing::Test {
 protected:
  RunSeedsTest() {
    Diagnostics diagnostics;
    const std::string root = SourceFolder() + "/robot_app/deployment/";
    scenario_ = LoadScenario(root + "scenario/scenario.yaml", diagnostics);
    ours_ = LoadControllers(root + "controllers.yaml", diagnostics).front();
    shipped_ = LoadShipped(SourceFolder(), diagnostics);
    EXPECT_TRUE(Shorten(1, scenario_));
    options_.folder = folder_.Path("ours");
  }
  Outcome Run(const std::vector<std::uint64_t>& seeds) {
    return RunSeeds(scenario_, *shipped_, ours_, seeds, options_);
  }

  TemporaryFolder folder_;
  Scenario scenario_;
  Controller ours_;
  std::optional<Shipped> shipped_;
  SeedOptions options_;
};

TEST_F(RunSeedsTest, ASeedThatHasItsFileIsNotRunAgain) {
  ASSERT_TRUE(Run({1}));
  const std::string file = NameOfSeed(options_.folder, 1) + ".json";
  const auto written = std::filesystem::last_write_time(file);
  options_.jobs = 2;
  ASSERT_TRUE(Run({1, 2}));
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_TRUE(LoadJournal(NameOfSeed(options_.folder, 2) + ".json"));
}

TEST_F(RunSeedsTest, RecordsLieBesideTheRunAndDoNotChangeIt) {
  ASSERT_TRUE(Run({1}));
  Journal without = LoadJournal(NameOfSeed(options_.folder, 1) + ".json").value();
  options_.folder = folder_.Path("recorded");
  options_.is_recorded = true;
  ASSERT_TRUE(Run({1}));
  Journal with = LoadJournal(NameOfSeed(options_.folder, 1) + ".json").value();
  EXPECT_THAT(with.records,
              ElementsAre("seed-0001.application.coppice", "seed-0001.monitor.coppice"));
  for (const std::string& record : with.records) {
    EXPECT_TRUE(std::filesystem::exists(options_.folder + "/" + record)) << record;
  }
  with.records.clear();
  with.cpu_seconds = without.cpu_seconds = 0;
  EXPECT_EQ(ToText(with), ToText(without));
}

TEST_F(RunSeedsTest, AFolderThatCannotBeWrittenIsAProblem) {
  options_.folder = "/proc/no/such/folder";
  EXPECT_FALSE(Run({1}));
}

}  // namespace
}  // namespace coppice::robot::deployment
