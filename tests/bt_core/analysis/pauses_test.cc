#include "bt_core/analysis/pauses.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

Time At(int seconds) { return Time(std::chrono::seconds(seconds)); }

Pauses PausesOf(const std::vector<Pause>& pauses) {
  Recording run;
  for (const Pause& pause : pauses) run.OnNote(NoteOf(pause));
  return Pauses(run);
}

TEST(Pauses, CountWhatLiesWithinTheStretchOnly) {
  const Pauses pauses = PausesOf({{At(10), At(20)}, {At(30), At(40)}});
  EXPECT_EQ(pauses.Within(At(15), At(32)), std::chrono::seconds(7));
  EXPECT_EQ(pauses.RunWithin(At(15), At(32)), std::chrono::seconds(10));
}

TEST(Pauses, AreNothingOutsideOfThem) {
  const Pauses pauses = PausesOf({{At(10), At(20)}});
  EXPECT_EQ(pauses.Within(At(0), At(10)), Duration(0));
  EXPECT_EQ(pauses.Within(At(20), At(30)), Duration(0));
}

TEST(Pauses, WhatOverlapsCountsOnceInAnyOrder) {
  const Pauses pauses = PausesOf({{At(15), At(25)}, {At(10), At(20)}});
  EXPECT_EQ(pauses.Within(At(0), At(60)), std::chrono::seconds(15));
}

TEST(Pauses, AStretchThatEndsBeforeItBeginsHasNone) {
  EXPECT_EQ(PausesOf({{At(10), At(20)}}).Within(At(18), At(12)), Duration(0));
}

}  // namespace
}  // namespace coppice
