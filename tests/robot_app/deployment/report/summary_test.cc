#include "robot_app/deployment/report/summary.h"

#include <gmock/gmock.h>

#include "robot_app/deployment/report/pictures.h"
#include "robot_app/deployment/report/report.h"
#include "tests/robot_app/deployment/made_journal.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::deployment {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::Pair;

Journal Named(const std::string& controller, std::uint64_t seed) {
  Journal journal = PublishedJournal();
  journal.controller = controller;
  journal.seed = seed;
  journal.spans = {{journal.span, Activity::kMoving}};
  return journal;
}

TEST(Summary, OursComesFirstThenThePublishedRobotThenTheOthersEachInTheOrderOfItsSeeds) {
  const auto groups =
      GroupsOf({Named("no-plan", 1), Named("published", 1), Named("ours", 2), Named("ours", 1)});
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].name, "ours");
  EXPECT_EQ(groups[0].journals[0].seed, 1u);
  EXPECT_EQ(groups[1].name, "published");
}

TEST(Summary, ADeploymentInAnotherWorldIsAGroupOfItsOwn) {
  Journal more = Named("ours", 1);
  more.times = 5;
  Journal less = Named("ours", 1);
  less.without = {"docking"};
  const auto groups = GroupsOf({Named("ours", 1), more, less});
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[1].name, "ours, faults x 5");
  EXPECT_EQ(groups[2].name, "ours, without docking");
}

TEST(Summary, TheTableOfMetricsHasThePublishedLifetimes) {
  const auto groups = GroupsOf({Named("published", 1)});
  EXPECT_THAT(ToMarkdown(MetricsTable(groups)),
              HasSubstr("| mean TSL [h] | 56.7 | 56.7 (56.7 – 56.7) |"));
}

TEST(Summary, WhatLiesOutsideOfItsIntervalIsSaid) {
  const auto groups = GroupsOf({Named("published", 1)});
  const std::string table = ToMarkdown(ValidationTable(groups[0]));
  EXPECT_THAT(table, HasSubstr("| unplanned stops | 4 | 1 – 8 | 4.0 | yes | 1 of 1 |"));
  EXPECT_THAT(table, HasSubstr("| wait and retry | 194 | 167 – 222 | 0.0 | NO | 0 of 1 |"));
}

TEST(Summary, ARobotThatNeverStoppedHasNoUpperBoundOfItsLifetime) {
  Journal journal = Named("ours", 1);
  journal.stops.clear();
  const std::string table = ToMarkdown(ComparisonTable(GroupsOf({journal})));
  EXPECT_THAT(table, HasSubstr("77 – ∞")) << "283.5 h over 3.69";
}

// Two lives that ended and one that was still going on.
TEST(Pictures, TheSurvivalFallsOnlyWhereALifeEnded) {
  Journal journal = Named("ours", 1);
  journal.span = {At("2021-03-02 00:00"), At("2021-03-03 00:00")};
  journal.stops = {{At("2021-03-02 04:00"), "", ""}, {At("2021-03-02 12:00"), "", ""}};
  EXPECT_THAT(Survival(GroupsOf({journal})[0]),
              ElementsAre(Pair(0, 1), Pair(4, testing::DoubleNear(2 / 3.0, 1e-9)),
                          Pair(8, testing::DoubleNear(1 / 3.0, 1e-9)),
                          Pair(12, testing::DoubleNear(1 / 3.0, 1e-9))));
}

TEST(Report, ThePageNeedsNoNetworkAndIsNoWayIn) {
  Journal journal = Named("ours", 1);
  journal.stops = {{At("2021-03-04 13:55"), "<script>", "a & b"}};
  const std::string page = HtmlReport(GroupsOf({journal, Named("published", 1)}), {});
  EXPECT_THAT(page, Not(HasSubstr("http")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, HasSubstr("a &amp; b"));
}

TEST(Report, AFolderWithoutRunsIsAProblem) {
  const TemporaryFolder folder;
  EXPECT_FALSE(LoadJournals({folder.path()}));
  EXPECT_FALSE(LoadJournals({folder.Path("nowhere")}));
}

}  // namespace
}  // namespace coppice::robot::deployment
