#include "editor/live/kept_marks.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(KeptMarks, BreakpointsAndBookmarksComeBack) {
  HookList hooks;
  Hook breakpoint;
  breakpoint.path = "round/Drive";
  breakpoint.condition = "battery < 20";
  breakpoint.from_hit = 3;
  breakpoint.enabled = false;
  breakpoint.position = HookPosition::kAfter;
  hooks.Add("robot:1667", breakpoint);
  Hook fault;
  fault.path = "round/Drive";
  fault.action = HookAction::kReplace;
  hooks.Add("", fault);
  Hook once;
  once.path = "round/Once";
  once.times = 1;
  hooks.Add("", once);
  Bookmarks bookmarks;
  bookmarks.Set("/runs/a.coppice", 7, R"(here "it" turns)");
  bookmarks.Set("robot:1667", 8, "gone with the run");

  LogPoints log_points;
  LogPoint point;
  point.run = "robot:1667";
  point.path = "round/Drive";
  ASSERT_EQ(ReadLogPoint("to {goal} if battery < 20 #3", point).problem(), "");
  log_points.Add(point);
  LanePins pins;
  pins.Toggle("robot:1667", "round/Drive");
  pins.Toggle("robot:1667", "round");

  HookList hooks_again;
  LogPoints points_again;
  Bookmarks bookmarks_again;
  LanePins pins_again;
  Diagnostics diagnostics;
  ReadMarks(WriteMarks({hooks, log_points, bookmarks, pins}), "marks",
            {hooks_again, points_again, bookmarks_again, pins_again}, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.ToString();
  ASSERT_EQ(hooks_again.all().size(), 1U) << "faults and single stops are not kept";
  const WantedHook& read = hooks_again.all()[0];
  EXPECT_EQ(read.robot, "robot:1667");
  EXPECT_EQ(read.hook.path, "round/Drive");
  EXPECT_EQ(ToString(read.hook), ToString(breakpoint));
  EXPECT_FALSE(read.hook.enabled);
  ASSERT_EQ(bookmarks_again.all().size(), 1U);
  EXPECT_EQ(bookmarks_again.Of("/runs/a.coppice").at(7), R"(here "it" turns)");
  ASSERT_EQ(points_again.all().size(), 1U);
  EXPECT_EQ(points_again.all()[0].run, "robot:1667");
  EXPECT_EQ(ToString(points_again.all()[0]), "to {goal} if battery < 20 #3");
  EXPECT_EQ(pins_again.Of("robot:1667"), (std::vector<std::string>{"round/Drive", "round"}));
}

TEST(KeptMarks, AFileOfAnOlderEditorIsRead) {
  HookList hooks;
  LogPoints log_points;
  Bookmarks bookmarks;
  LanePins pins;
  Diagnostics diagnostics;
  ReadMarks(R"({"breakpoints": [{"path": "a"}], "bookmarks": {}})", "marks",
            {hooks, log_points, bookmarks, pins}, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty()) << diagnostics.ToString();
  EXPECT_EQ(hooks.all().size(), 1U);
}

TEST(KeptMarks, ATextThatIsNoneAddsNothingAndSaysWhy) {
  for (const char* text : {"", "{", "[]", R"({"breakpoints": [{}], "bookmarks": {}})",
                           R"({"breakpoints": [{"path": "a"}], "bookmarks": {"r": [1]}})",
                           R"({"breakpoints": [{"path": "a"}], "bookmarks": {}, )"
                           R"("pins": [7]})"}) {
    HookList hooks;
    LogPoints log_points;
    Bookmarks bookmarks;
    LanePins pins;
    Diagnostics diagnostics;
    ReadMarks(text, "marks", {hooks, log_points, bookmarks, pins}, diagnostics);
    EXPECT_TRUE(hooks.all().empty()) << text;
    EXPECT_TRUE(bookmarks.all().empty()) << text;
    EXPECT_EQ(diagnostics.all().size(), 1U) << text;
  }
}

}  // namespace
}  // namespace coppice::editor
