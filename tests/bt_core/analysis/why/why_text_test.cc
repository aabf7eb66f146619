#include "bt_core/analysis/why/why_text.h"

#include <gtest/gtest.h>

#include <memory>

namespace coppice {
namespace {

constexpr NodeIndex kDecides{0};
constexpr NodeIndex kAsked{1};
constexpr NodeIndex kOther{2};

RecordedTree Patrol() {
  auto description = std::make_shared<TreeDescription>();
  description->nodes.resize(3);
  description->nodes[kDecides].path = "patrol";
  description->nodes[kAsked].path = "patrol/go to dock";
  description->nodes[kOther].path = "patrol/is charged";
  RecordedTree tree;
  tree.description = description;
  return tree;
}

struct Reason {
  WhyNot::Cause cause;
  const char* sentence;
};

class WhyNotText : public testing::TestWithParam<Reason> {};

TEST_P(WhyNotText, IsOneEnglishSentenceWithNamesInQuotes) {
  const WhyNot why_not{GetParam().cause, kDecides, kAsked, kOther, Status::kFailure};
  EXPECT_EQ(SentenceOf(Patrol(), why_not), GetParam().sentence);
}

using Cause = WhyNot::Cause;
INSTANTIATE_TEST_SUITE_P(
    EveryCause, WhyNotText,
    testing::Values(
        Reason{Cause::kNoTick, "the tree was not ticked then"},
        Reason{Cause::kChild, R"("patrol" did not reach "go to dock", )"
                              R"(because "is charged", which comes before it, is FAILURE)"},
        Reason{Cause::kDone,
               R"("patrol" did not tick "go to dock" again, because it is already FAILURE)"},
        Reason{Cause::kPassedOver, R"("patrol" did not choose "go to dock"; )"
                                   R"(it ticked "is charged", which is FAILURE)"},
        Reason{Cause::kOwn, R"("patrol" ticked none of its children and is FAILURE)"},
        Reason{Cause::kInjected, R"("patrol" was made FAILURE from outside, without being ticked)"},
        Reason{Cause::kNotWhole, "the tick has stopped at a breakpoint"},
        Reason{Cause::kAborted, R"(an exception thrown by "patrol" ended the tick)"},
        Reason{Cause::kNotTold, R"(this run holds status changes only, and "go to dock" )"
                                "had none; it may have been ticked"}));

TEST(WhyChangeText, SaysWhatTheNodeWasBefore) {
  WhyStep step{};
  step.node = kAsked;
  step.result = Status::kSuccess;
  step.before = Status::kRunning;
  EXPECT_EQ(SentenceOf(Patrol(), WhyChange{step, true}),
            R"("patrol/go to dock" is SUCCESS and was RUNNING before)");
}

TEST(WhyChangeText, SaysThatTheNodeWasNotTickedBefore) {
  WhyStep step{};
  step.node = kAsked;
  step.result = Status::kSuccess;
  EXPECT_EQ(SentenceOf(Patrol(), WhyChange{step, false}),
            R"("patrol/go to dock" is SUCCESS and was not ticked before)");
}

}  // namespace
}  // namespace coppice
