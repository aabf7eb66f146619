#include "robot_app/monitoring/system/sockets.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <utility>

namespace coppice::robot::monitoring {
namespace {

TEST(Socket, OneOwnsTheDescriptor) {
  std::string error;
  Socket first = ListenUdp("127.0.0.1", 0, error);
  ASSERT_TRUE(first.is_open()) << error;
  const int port = PortOf(first);
  EXPECT_GT(port, 0);
  Socket second = std::move(first);
  EXPECT_TRUE(second.is_open());
  EXPECT_EQ(PortOf(second), port);
  second = Socket();  // closes it: the port is free again
  EXPECT_TRUE(ListenUdp("127.0.0.1", port, error).is_open()) << error;
}

TEST(Socket, ABadAddressIsAnErrorWithItsName) {
  std::string error;
  EXPECT_FALSE(Connect("not an address", 80, SOCK_STREAM, error).is_open());
  EXPECT_EQ(error.rfind(R"("not an address": )", 0), 0u) << error;
}

TEST(Socket, NumericAddressesOfBothKindsWork) {
  std::string error;
  EXPECT_TRUE(Connect("127.0.0.1", 9, SOCK_DGRAM, error).is_open()) << error;
}

TEST(Deadline, RoundsUpAndPasses) {
  EXPECT_TRUE(Deadline(Duration::zero()).has_passed());
  EXPECT_TRUE(Deadline(-std::chrono::seconds(1)).has_passed());
  const Deadline far(std::chrono::seconds(100));
  EXPECT_FALSE(far.has_passed());
  EXPECT_GT(far.milliseconds(), 50000);
  EXPECT_LE(far.milliseconds(), 100000);
}

}  // namespace
}  // namespace coppice::robot::monitoring
