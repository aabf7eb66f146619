#include "bt_core/live/web/local_address.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

TEST(LocalAddress, TakesTheAddressOfAnInterface) {
  EXPECT_EQ(LocalAddress("lo"), "127.0.0.1");
  EXPECT_EQ(LocalAddress("*"), "0.0.0.0");
}

TEST(LocalAddress, LeavesTheRestAsItIs) {
  EXPECT_EQ(LocalAddress("127.0.0.2"), "127.0.0.2");
  EXPECT_EQ(LocalAddress("no such place"), "no such place");
}

}  // namespace
}  // namespace coppice
