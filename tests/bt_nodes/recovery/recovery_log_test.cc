#include "bt_nodes/recovery/recovery_log.h"

#include <gtest/gtest.h>

namespace coppice::leaves {
namespace {

TEST(RecoveryPhase, HasANameForPeople) {
  EXPECT_STREQ(ToString(RecoveryPhase::kBegun), "begun");
  EXPECT_STREQ(ToString(RecoveryPhase::kRefused), "refused");
}

}  // namespace
}  // namespace coppice::leaves
