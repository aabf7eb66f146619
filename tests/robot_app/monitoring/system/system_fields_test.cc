#include "robot_app/monitoring/system/system_fields.h"

#include <gmock/gmock.h>

#include "robot_app/monitoring/gauges/band_fields.h"
#include "robot_app/monitoring/system/system_gauges.h"
#include "tests/robot_app/monitoring/fields_fixture.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::seconds;
using testing::ElementsAre;
using testing::HasSubstr;

class SystemFieldsTest : public FieldsTest {
 protected:
  std::vector<std::string> SubjectsOf(const std::string& text) {
    YamlFields fields = Open(text);
    std::vector<std::string> subjects;
    for (const GaugeWatch& gauge : GaugesOf(ReadSystemWatch(fields))) {
      subjects.push_back(gauge.monitor + " " + gauge.subject);
    }
    return subjects;
  }
};

TEST_F(SystemFieldsTest, EveryComputerHasProcessorAndMemory) {
  EXPECT_THAT(SubjectsOf("{}"), ElementsAre("cpu load", "cpu temperature", "memory used"));
  YamlFields fields = Open("{period: 2, cpu: {load: {error: [none, 0.5]}}}");
  const SystemWatch watch = ReadSystemWatch(fields);
  EXPECT_EQ(watch.period, seconds(2));
  EXPECT_EQ(watch.window, seconds(5));
  EXPECT_EQ(watch.cpu_load.error, (Range{std::nullopt, 0.5}));
  EXPECT_EQ(watch.memory_used, AtMost(0.85, 0.95, 3));
  EXPECT_EQ(Errors(), "");
}

TEST_F(SystemFieldsTest, EachThingThatIsNamedHasItsGauges) {
  EXPECT_THAT(SubjectsOf(R"(
disks: [{path: /}]
network: [{interface: eth0}]
clocks: [{host: arm}]
hosts: [{host: arm}]
processes: [{node: /base}])"),
              ElementsAre("cpu load", "cpu temperature", "memory used", "disk /",
                          "network eth0 load", "network eth0 errors", "network eth0 drops",
                          "clock arm", "network host arm", "process /base cpu",
                          "process /base memory", "process /base threads", "process /base files"));
  EXPECT_EQ(Errors(), "");
}

TEST_F(SystemFieldsTest, AComputerIsAskedByItsNameUnlessItHasAnAddress) {
  YamlFields fields = Open("clocks: [{host: arm}, {host: base, address: 10.0.0.2, port: 1123}]");
  const SystemWatch watch = ReadSystemWatch(fields);
  ASSERT_EQ(watch.clocks.size(), 2U);
  EXPECT_EQ(watch.clocks[0].address, "arm");
  EXPECT_EQ(watch.clocks[0].port, 123);
  EXPECT_EQ(watch.clocks[1].address, "10.0.0.2");
  EXPECT_EQ(watch.clocks[1].port, 1123);
  EXPECT_EQ(Errors(), "");
}

TEST_F(SystemFieldsTest, OnlyAClockThatIsNamedMustServeTime) {
  YamlFields fields = Open("clocks: [{host: arm}, {host: '*', port: 1123}]");
  const SystemWatch watch = ReadSystemWatch(fields);
  EXPECT_TRUE(watch.clocks.at(0).must_serve);
  EXPECT_FALSE(watch.clocks.at(1).must_serve);
  EXPECT_EQ(watch.clocks[1].port, 1123);
  EXPECT_EQ(Errors(), "");
}

TEST_F(SystemFieldsTest, EveryHostHasAnAddressOfItsOwn) {
  SubjectsOf("hosts: [{host: '*', address: 10.0.0.2}]");
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"address\""));
}

TEST_F(SystemFieldsTest, TheSameThingTwiceIsAnError) {
  SubjectsOf("disks: [{path: /}, {path: /}]");
  EXPECT_THAT(Errors(), HasSubstr("\"/\""));
}

TEST_F(SystemFieldsTest, AWrongNumberIsAnErrorWithItsLimits) {
  SubjectsOf("hosts: [{host: arm, port: 70000}]");
  EXPECT_THAT(Errors(), HasSubstr("65535"));
}

}  // namespace
}  // namespace coppice::robot::monitoring
