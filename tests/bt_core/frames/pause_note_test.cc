#include "bt_core/frames/pause_note.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

using std::chrono::microseconds;

TEST(PauseNote, TellsSecondsThatPeopleCanRead) {
  const HistoryNote note = NoteOf({Time(microseconds(5)), Time(microseconds(2'500'005))});
  EXPECT_EQ(note.kind, "pause");
  EXPECT_EQ(note.text, "2.500000 s");
}

TEST(PauseNote, TellsInWhichTickTheTreeStood) {
  const Pause pause{Time(microseconds(5)), Time(microseconds(5)), 7, microseconds(2'500'000)};
  EXPECT_EQ(NoteOf(pause).text, "0.000000 s, 2.500000 s of tick 7");
  const std::optional<Pause> read = PauseOf(NoteOf(pause));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->tick, 7u);
  EXPECT_EQ(read->of_tick, pause.of_tick);
  EXPECT_EQ(read->to, pause.to);
}

TEST(PauseNote, IsReadAsItWasWritten) {
  const Pause pause{Time(microseconds(7)), Time(microseconds(1'000'012'345'678))};
  const std::optional<Pause> read = PauseOf(NoteOf(pause));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->from, pause.from);
  EXPECT_EQ(read->to, pause.to);
}

TEST(PauseNote, WhatSaysNoTimeIsNoPause) {
  for (const char* text :
       {"", "a while", "-1.000000 s", "1 s", "1.000000 s ", "1e99 s", "nan s", "1.000000 s, ",
        "1.000000 s, 1.000000 s of tick 0", "1.000000 s, of tick 7"}) {
    EXPECT_FALSE(PauseOf({Time{}, kPauseKind, text})) << text;
  }
  EXPECT_FALSE(PauseOf({Time{}, "operator", "1.000000 s"}));
  EXPECT_FALSE(PauseOf({Time::max(), kPauseKind, "1.000000 s"})) << "its end is no time";
}

}  // namespace
}  // namespace coppice
