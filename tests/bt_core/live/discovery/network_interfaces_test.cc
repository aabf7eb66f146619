#include "bt_core/live/discovery/network_interfaces.h"

#include <gmock/gmock.h>

namespace coppice {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

std::vector<std::string> Names(const std::string& address) {
  std::vector<std::string> names;
  for (const NetworkInterface& one : InterfacesOf(address)) names.push_back(one.name);
  return names;
}

TEST(NetworkInterfaces, WhoListensOnThisComputerAloneIsInNoOtherNetwork) {
  EXPECT_THAT(Names("127.0.0.1"), testing::ElementsAre("lo"));
  EXPECT_THAT(Names("127.0.0.2"), testing::ElementsAre("lo"));
  EXPECT_THAT(Names("lo"), testing::ElementsAre("lo"));
}

TEST(NetworkInterfaces, WhoListensEverywhereIsInAll) {
  EXPECT_THAT(Names("*"), testing::Contains("lo"));
  EXPECT_EQ(Names("*"), Names("0.0.0.0"));
}

TEST(NetworkInterfaces, AnAddressOfNobodyIsInNone) {
  EXPECT_THAT(Names("203.0.113.77"), IsEmpty());
  EXPECT_THAT(Names("no such interface"), IsEmpty());
}

TEST(NetworkInterfaces, ANetworkReachesWhatItsMaskSays) {
  const NetworkInterface home{"eth0", {192, 168, 1, 7}, {255, 255, 255, 0}};
  EXPECT_TRUE(home.Reaches({192, 168, 1, 200}));
  EXPECT_FALSE(home.Reaches({192, 168, 2, 7}));
  EXPECT_FALSE(home.Reaches({127, 0, 0, 1}));
}

}  // namespace
}  // namespace coppice
