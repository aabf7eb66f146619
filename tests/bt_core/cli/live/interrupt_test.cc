#include "bt_core/cli/live/interrupt.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(Interrupt, IsRememberedAndForgottenByTheNext) {
  {
    const Interrupt interrupt;
    EXPECT_FALSE(interrupt.came());
    std::raise(SIGINT);
    EXPECT_TRUE(interrupt.came());
  }
  const Interrupt next;
  EXPECT_FALSE(next.came());
  std::raise(SIGTERM);
  EXPECT_TRUE(next.came());
}

}  // namespace
}  // namespace coppice
