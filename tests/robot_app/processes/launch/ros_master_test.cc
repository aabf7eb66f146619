#include "robot_app/processes/launch/ros_master.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "tests/robot_app/processes/temporary.h"

namespace coppice::robot::processes {
namespace {

using std::chrono::seconds;

class RosMasterTest : public testing::Test {
 protected:
  RosMasterTest() { NodeProbe::SilenceLibrary(); }
  PosixLauncher launcher_{Temporary("ros_master_test")};
};

TEST_F(RosMasterTest, StartsAMasterAtAFreePortAndFindsItAgain) {
  const RosMaster master = FindOrStartMaster(0, launcher_, seconds(20)).value();
  EXPECT_GT(master.pid, 0);
  EXPECT_EQ(master.Uri(), "http://127.0.0.1:" + std::to_string(master.address.port));
  EXPECT_TRUE(MasterAnswers(master.address, seconds(2)));

  const RosMaster found = FindOrStartMaster(master.address.port, launcher_, seconds(20)).value();
  EXPECT_EQ(found.pid, 0);  // not ours

  launcher_.Signal(master.pid, SIGTERM);
  waitpid(master.pid, nullptr, 0);
  EXPECT_FALSE(MasterAnswers(master.address, seconds(2)));
}

TEST_F(RosMasterTest, RefusesAPortThatSomethingElseHas) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  ASSERT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(listen(listener, 5), 0);
  ASSERT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const int port = ntohs(address.sin_port);
  EXPECT_EQ(FindOrStartMaster(port, launcher_, seconds(20)).problem(),
            "port " + std::to_string(port) + " is in use by something that is no ROS master");
  close(listener);
}

// A port that Linux gives to whoever connects may be somebody's before it is used.
TEST(FreePort, LiesBelowThePortsThatLinuxGivesAway) {
  std::ifstream range("/proc/sys/net/ipv4/ip_local_port_range");
  int first_given_away = 0;
  range >> first_given_away;
  const int port = FreePort();
  EXPECT_GT(port, 1023);
  EXPECT_LT(port, first_given_away);
}

TEST(FreePort, IsTheFirstOfAsManyInARowAsAreWanted) {
  constexpr int kInARow = 4;
  const int port = FreePort(kInARow);
  ASSERT_GT(port, 1023);
  for (int i = 0; i < kInARow; ++i) {
    const int listener = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port + i));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0) << i;
    close(listener);
  }
}

}  // namespace
}  // namespace coppice::robot::processes
