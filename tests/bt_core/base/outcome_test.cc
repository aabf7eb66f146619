#include "bt_core/base/outcome.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

namespace coppice {
namespace {

TEST(Outcome, IsDoneIfNothingIsSaid) {
  const Outcome outcome;
  EXPECT_TRUE(outcome.ok());
  EXPECT_TRUE(outcome);
  EXPECT_EQ(outcome.problem(), "");
}

TEST(Outcome, OfAProblemKeepsItsText) {
  const Outcome outcome = Problem{"the disk is full"};
  EXPECT_FALSE(outcome.ok());
  EXPECT_FALSE(outcome);
  EXPECT_EQ(outcome.problem(), "the disk is full");
}

TEST(Outcome, OfAProblemWithoutTextHasFailedAllTheSame) { EXPECT_FALSE(Outcome(Problem{})); }

Outcome Failed() { return Problem{"a text that is too long to lie in the string itself"}; }

TEST(Outcome, OfATemporaryHandsOutItsText) {
  const std::string& text = Failed().problem();
  EXPECT_EQ(text, "a text that is too long to lie in the string itself");
}

TEST(Expected, HasItsValue) {
  const Expected<std::string> name = "dock";
  ASSERT_TRUE(name);
  EXPECT_EQ(*name, "dock");
  EXPECT_EQ(name.value(), "dock");
  EXPECT_EQ(name->size(), 4u);
  EXPECT_EQ(name.problem(), "");
}

TEST(Expected, OfAProblemHasNoValue) {
  const Expected<std::string> name = Problem{"no such place"};
  EXPECT_FALSE(name.ok());
  EXPECT_EQ(name.problem(), "no such place");
  EXPECT_THROW(name.value(), std::bad_optional_access);
}

TEST(Expected, HandsOnWhatCannotBeCopied) {
  Expected<std::unique_ptr<int>> number = std::make_unique<int>(7);
  const std::unique_ptr<int> taken = *std::move(number);
  EXPECT_EQ(*taken, 7);
}

}  // namespace
}  // namespace coppice
