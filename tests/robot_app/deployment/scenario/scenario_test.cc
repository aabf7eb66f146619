#include "robot_app/deployment/scenario/scenario.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::deployment {
namespace {

using testing::HasSubstr;

Scenario Shipped() {
  Diagnostics diagnostics;
  Scenario scenario =
      LoadScenario(SourceFolder() + "/robot_app/deployment/scenario/scenario.yaml", diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  return scenario;
}

TEST(Scenario, EveryShippedNumberSaysWhereItIsFrom) {
  const Scenario scenario = Shipped();
  EXPECT_GT(scenario.numbers.size(), 40u);
  for (const SourcedNumber& number : scenario.numbers) EXPECT_NE(number.source, "") << number.name;
  EXPECT_EQ(scenario.calendar.working_days(), 12);
}

TEST(Scenario, ThePublishedLadderFollowsFromItsMixtureOfBlockages) {
  const Scenario s = Shipped();
  const double closed = 1 - s.blockage_passing - s.blockage_trap;
  const double again =
      s.blockage_passing * s.again_after_passing + s.blockage_trap * s.again_after_trap;
  const double waits = 162 / (1 - again);
  EXPECT_NEAR(waits, 194, 2);
  // What begins while another is repaired makes the calibrated shares smaller than the ladder's.
  EXPECT_NEAR(waits * (1 - s.blockage_passing), 41, 4) << "moves backwards";
  EXPECT_NEAR(waits * closed, 5, 2) << "persons asked";
}

TEST(Scenario, AFaultCanBeLeftOutAndAllBeMoreFrequent) {
  Scenario scenario = Shipped();
  const double blockages = scenario.rate(Fault::kBlockage);
  ASSERT_TRUE(Without("docking", scenario));
  MultiplyFaults(5, scenario);
  EXPECT_EQ(scenario.rate(Fault::kDocking), 0);
  EXPECT_EQ(scenario.rate(Fault::kBlockage), 5 * blockages);
  EXPECT_THAT(Without("dokcing", scenario).problem(), HasSubstr("docking"));
}

TEST(Scenario, AFileWithoutSourcesIsRefusedAtItsLines) {
  Diagnostics diagnostics;
  const TemporaryFolder folder;
  std::ofstream(folder.Path("s.yaml")) << "faults:\n  blockage: {value: 1}\n";
  LoadScenario(folder.Path("s.yaml"), diagnostics);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("s.yaml:2"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("source"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"docking\" is missing"));
}

}  // namespace
}  // namespace coppice::robot::deployment
