#include "editor/panels/run_text.h"

#include <gtest/gtest.h>

#include "tests/editor/executed_source.h"

namespace coppice::editor {
namespace {

TEST(RunText, WritesTimesOfARun) {
  EXPECT_EQ(AxisText(std::chrono::milliseconds(4220)), "0:04.220");
  EXPECT_EQ(AxisText(std::chrono::milliseconds(3723250)), "1:02:03.250");
  EXPECT_EQ(AxisText(Time(-5)), "0:00.000");
}

}  // namespace
}  // namespace coppice::editor
