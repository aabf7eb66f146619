#include "robot_app/deployment/figures/journal_file.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/robot_app/deployment/made_journal.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::deployment {
namespace {

Journal Full() {
  Journal journal = PublishedJournal();
  journal.seed = 7;
  journal.without = {"docking"};
  journal.spans = {{journal.span, Activity::kMoving}};
  journal.stands = {journal.span};
  leaves::RecoveryEvent event;
  event.recovery = "slow rotate";
  event.subject = "localization";
  event.time = journal.span.from;
  event.pose = leaves::Pose2D{1, 2, 3};
  journal.recoveries = {event};
  journal.requests = {{"docking", journal.span.from, kNever, false, "open"}};
  journal.dockings = {{journal.span.from, 2, true, true, 75.5}};
  journal.starts = {{"odometry_filter", journal.span.from, 4.5, "exit"}};
  journal.faults = {{journal.span.from, "blockage", "passing", 75}};
  journal.battery = {{journal.span.from, 0.5}};
  journal.distance = 66600;
  journal.with_mask = 983;
  journal.records = {"seed-0007.monitor.coppice"};
  return journal;
}

TEST(JournalFile, WhatWasSavedIsReadBack) {
  const std::string text = ToText(Full());
  const auto journal = JournalFromText(text);
  ASSERT_TRUE(journal) << journal.problem();
  EXPECT_EQ(ToText(*journal), text);
}

TEST(JournalFile, WhatIsNoRunIsAProblemAndNoCrash) {
  const std::string text = ToText(Full());
  for (std::size_t length = 0; length + 2 < text.size(); length += 37) {
    EXPECT_FALSE(JournalFromText(text.substr(0, length)));
  }
  EXPECT_FALSE(JournalFromText("{}"));
  EXPECT_FALSE(JournalFromText("[1]"));
  EXPECT_FALSE(JournalFromText(R"({"version":99})"));
}

TEST(JournalFile, TimesWithoutAnEndAreNone) {
  const nlohmann::json whole = nlohmann::json::parse(ToText(Full()));
  for (const char* const time : {"null", "-1", "9223372036854775807", "1e30"}) {
    nlohmann::json json = whole;
    json["span"][1] = nlohmann::json::parse(time);
    EXPECT_FALSE(JournalFromText(json.dump())) << time;
    json = whole;
    json["stops"] = {{{"at", nlohmann::json::parse(time)}, {"cause", "docking"}, {"what", ""}}};
    EXPECT_FALSE(JournalFromText(json.dump())) << time;
  }
}

TEST(JournalFile, AFolderThatIsNotThereIsAProblem) {
  const TemporaryFolder folder;
  EXPECT_FALSE(SaveJournal(Full(), folder.path() + "/no/such/journal.json"));
  EXPECT_FALSE(LoadJournal(folder.path() + "/journal.json"));
}

}  // namespace
}  // namespace coppice::robot::deployment
