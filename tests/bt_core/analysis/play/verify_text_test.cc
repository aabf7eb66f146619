// What a verification found, for people and as JSON.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bt_core/analysis/play/verify.h"

namespace coppice {
namespace {

constexpr Time kStart{std::chrono::seconds(100)};

Verification Parted() {
  Verification parted;
  parted.ticks = 12;
  parted.events = 34;
  parted.skipped_ticks = 2;
  parted.remarks = {"begins in the midst of a run"};
  parted.divergence =
      Divergence{13, kStart + std::chrono::milliseconds(1500), "patrol/dock", "SUCCESS", "FAILURE"};
  return parted;
}

TEST(VerifyText, SaysThatRunsAreTheSame) {
  Verification same;
  same.ticks = 1200;
  same.events = 34567;
  EXPECT_EQ(PrintVerification(same, kStart), "1200 ticks, 34567 events: the same\n");
  EXPECT_EQ(PrintVerification({}, kStart), "0 ticks, 0 events: nothing could be verified\n");
}

TEST(VerifyText, SaysWhereRunsPartAndWhatWasLeftOut) {
  EXPECT_EQ(PrintVerification(Parted(), kStart),
            "12 ticks, 34 events: the same until tick 13 at 1.500000 s\n"
            "  node:     patrol/dock\n"
            "  recorded: SUCCESS\n"
            "  now:      FAILURE\n"
            "2 ticks were not verified\n"
            "begins in the midst of a run\n");
  Verification nameless = Parted();
  nameless.divergence->node.clear();
  EXPECT_EQ(PrintVerification(nameless, kStart).find("node:"), std::string::npos);
}

TEST(VerifyText, IsJson) {
  const auto parted = nlohmann::json::parse(VerificationToJson(Parted(), kStart));
  EXPECT_EQ(parted["same"], false);
  EXPECT_EQ(parted["ticks"], 12);
  EXPECT_EQ(parted["skipped_ticks"], 2);
  EXPECT_EQ(parted["remarks"][0], "begins in the midst of a run");
  EXPECT_EQ(parted["divergence"]["time"], 1.5);
  EXPECT_EQ(parted["divergence"]["node"], "patrol/dock");
  Verification same;
  EXPECT_EQ(nlohmann::json::parse(VerificationToJson(same, kStart))["same"], false)
      << "nothing was verified";
  same.ticks = 1;
  const auto json = nlohmann::json::parse(VerificationToJson(same, kStart));
  EXPECT_EQ(json["same"], true);
  EXPECT_FALSE(json.contains("divergence"));
}

}  // namespace
}  // namespace coppice
