// The shipped set-up of the clocks with the real chronyd, which leaves the computer's clock alone.
#include <gtest/gtest.h>

#include "robot_app/common/child_process.h"
#include "robot_app/monitoring/system/sntp.h"
#include "robot_app/monitoring/system/time_server.h"
#include "tests/robot_app/eventually.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::monitoring {
namespace {

int FreeUdpPort() {
  const TimeServer server("127.0.0.1", 0, Duration::zero());
  return server.port();
}

TEST(Chrony, OfTheMainComputerServesItsTimeWithoutTheInternet) {
  const TemporaryFolder folder;
  const int port = FreeUdpPort();
  WriteFile(folder.Path("chrony.conf"),
            "include " + SourceFolder() + "/robot_app/config/chrony/main.conf\n" +
                "allow 127.0.0.1\nbindaddress 127.0.0.1\nport " + std::to_string(port) +
                "\ncmdport 0\nbindcmdaddress /\npidfile " + folder.Path("pid") + "\n");
  ChildProcess chronyd({"/usr/sbin/chronyd", "-d", "-x", "-U", "-f", folder.Path("chrony.conf")},
                       folder.Path("log"));
  std::string problem;
  EXPECT_TRUE(Eventually([&] {
    const auto readings = QueryClocks({{"127.0.0.1", port}}, std::chrono::milliseconds(200));
    problem = readings[0].problem();
    return readings[0].ok() && std::abs(readings[0]->offset) < 1;
  })) << problem
      << "\n"
      << ReadFile(folder.Path("log"));
}

TEST(Chrony, OfTheOtherComputersIsUnderstood) {
  const TemporaryFolder folder;
  ChildProcess chronyd(
      {"/usr/sbin/chronyd", "-p", "-f", SourceFolder() + "/robot_app/config/chrony/other.conf"},
      folder.Path("log"));
  EXPECT_TRUE(Eventually([&] { return !chronyd.IsRunning(); }));
  EXPECT_EQ(chronyd.exit_status(), 0) << ReadFile(folder.Path("log"));
}

}  // namespace
}  // namespace coppice::robot::monitoring
