#include "bt_core/live/server/wake_descriptor.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <thread>

namespace coppice {
namespace {

bool IsReadable(const WakeDescriptor& wake, int patience_ms = 0) {
  pollfd item{wake.descriptor(), POLLIN, 0};
  return poll(&item, 1, patience_ms) == 1;
}

TEST(WakeDescriptor, IsReadableFromAWakeToTheReset) {
  WakeDescriptor wake;
  EXPECT_FALSE(IsReadable(wake));
  wake.Wake();
  wake.Wake();
  EXPECT_TRUE(IsReadable(wake));
  wake.Reset();
  EXPECT_FALSE(IsReadable(wake));
  wake.Wake();
  EXPECT_TRUE(IsReadable(wake));
}

TEST(WakeDescriptor, EndsAPollOfAnotherThread) {
  WakeDescriptor wake;
  std::thread other([&] { wake.Wake(); });
  EXPECT_TRUE(IsReadable(wake, 30000));
  other.join();
}

}  // namespace
}  // namespace coppice
