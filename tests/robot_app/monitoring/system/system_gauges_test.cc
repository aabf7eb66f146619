#include "robot_app/monitoring/system/system_gauges.h"

#include <gmock/gmock.h>

namespace coppice::robot::monitoring {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

InterfaceWatch Link(const std::string& name, double speed) {
  InterfaceWatch watch;
  watch.interface = name;
  watch.speed = speed;
  return watch;
}

std::vector<std::string> LinksOf(const SystemWatch& watch) {
  std::vector<std::string> links;
  for (const InterfaceWatch& link : watch.interfaces) {
    links.push_back(link.interface + " " + std::to_string(static_cast<int>(link.speed)));
  }
  return links;
}

TEST(SystemGauges, APatternStandsForTheLinksThatMatchIt) {
  SystemWatch watch;
  watch.interfaces = {Link("wl*", 300)};
  EXPECT_THAT(LinksOf(WithNames(watch, {"eth0", "wlan0", "wlp3s0"}, {})),
              ElementsAre("wlan0 300", "wlp3s0 300"));
  EXPECT_THAT(LinksOf(WithNames(watch, {}, {})), IsEmpty());
}

TEST(SystemGauges, ALinkThatIsNamedIsAsItIsWrittenThereAndNeedNotBeThere) {
  SystemWatch watch;
  watch.interfaces = {Link("*", 1000), Link("eth0", 100), Link("eth9", 10)};
  EXPECT_THAT(LinksOf(WithNames(watch, {"eth0", "eth1"}, {})),
              ElementsAre("eth0 100", "eth9 10", "eth1 1000"));
}

TEST(SystemGauges, EveryHostStandsForTheOtherComputers) {
  SystemWatch watch;
  watch.hosts.resize(2);
  watch.hosts[0].host = kEveryHost;
  watch.hosts[0].port = 80;
  watch.hosts[1].host = "base";
  watch.hosts[1].address = "base.local";
  const SystemWatch named = WithNames(watch, {}, {{"base", "10.0.0.2"}, {"jetson", "10.0.0.3"}});
  ASSERT_EQ(named.hosts.size(), 2U);
  EXPECT_EQ(named.hosts[0].address, "base.local");
  EXPECT_EQ(named.hosts[1].host, "jetson");
  EXPECT_EQ(named.hosts[1].address, "10.0.0.3");
  EXPECT_EQ(named.hosts[1].port, 80);
}

}  // namespace
}  // namespace coppice::robot::monitoring
