#include "robot_app/monitoring/system/sockets.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <utility>

namespace coppice::robot::monitoring {
namespace {

TEST(Socket, OneOwnsTheDescriptor) {
  Socket first = ListenUdp("127.0.0.1", 0).value();
  const int port = PortOf(first);
  EXPECT_GT(port, 0);
  Socket second = std::move(first);
  EXPECT_TRUE(second.is_open());
  EXPECT_EQ(PortOf(second), port);
  second = Socket();  // closes it: the port is free again
  EXPECT_EQ(ListenUdp("127.0.0.1", port).problem(), "");
}

TEST(Socket, ABadAddressIsAnErrorWithItsName) {
  const std::string error = Connect("not an address", 80, SOCK_STREAM).problem();
  EXPECT_EQ(error.rfind(R"("not an address": )", 0), 0u) << error;
}

TEST(Socket, NumericAddressesOfBothKindsWork) {
  EXPECT_EQ(Connect("127.0.0.1", 9, SOCK_DGRAM).problem(), "");
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
