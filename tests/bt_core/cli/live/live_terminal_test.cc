#include "bt_core/cli/live/live_terminal.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice {
namespace {

TEST(LiveTerminal, DrawsInPlaceAndGivesTheScreenBack) {
  testing::internal::CaptureStdout();
  {
    LiveTerminal terminal;
    terminal.Draw({"one", "two"});
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(),
            "\x1b[?1049h\x1b[?25l\x1b[Hone\x1b[K\r\ntwo\x1b[K\x1b[J\x1b[?25h\x1b[?1049l");
}

}  // namespace
}  // namespace coppice
