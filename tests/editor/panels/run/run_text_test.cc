#include "editor/panels/run/run_text.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunText, WritesTimesOfARun) {
  EXPECT_EQ(AxisText(Time(std::chrono::milliseconds(4220))), "0:04.220");
  EXPECT_EQ(AxisText(Time(std::chrono::milliseconds(3723250))), "1:02:03.250");
  EXPECT_EQ(AxisText(Time(Duration(-5))), "0:00.000");
}

TEST(RunText, TellsOfPausesThatHaveEndedAndOfTheOneThatGoesOn) {
  Statistics figures;
  figures.ticks = 1;
  const std::string none = SentenceOf(figures, false, false);
  EXPECT_EQ(none.rfind("whole run: 1 tick of 0.000 ms", 0), 0U) << none;
  EXPECT_EQ(SentenceOf(figures, false, true), none + ", is paused now");
  figures.paused = std::chrono::milliseconds(4200);
  EXPECT_EQ(SentenceOf(figures, false, false), none + ", paused for 4.2 s");
  EXPECT_EQ(SentenceOf(figures, false, true), none + ", paused for 4.2 s and is paused now");
}

TEST(RunText, RoundsNumbersThatAreTooLongForATable) {
  EXPECT_EQ(ShortNumber("0.43199999999999994"), "0.432");
  EXPECT_EQ(ShortNumber("-12345.678901"), "-12345.7");
  EXPECT_EQ(ShortNumber("0.25"), "0.25");
  EXPECT_EQ(ShortNumber("6.76e+04"), "67600") << "no powers of ten";
  EXPECT_EQ(ShortNumber("1e+05"), "100000");
  EXPECT_EQ(ShortNumber("6761234.25"), "6761234");
  EXPECT_EQ(ShortNumber("12345678901"), "12345678901") << "a whole number stays whole";
  EXPECT_EQ(ShortNumber("0.5;0.25;0.125"), "0.5;0.25;0.125");
  EXPECT_EQ(ShortNumber("kitchen.north"), "kitchen.north");
}

}  // namespace
}  // namespace coppice::editor
