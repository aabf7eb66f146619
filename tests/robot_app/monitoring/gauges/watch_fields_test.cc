#include "robot_app/monitoring/gauges/watch_fields.h"

#include <gmock/gmock.h>

#include "robot_app/monitoring/gauges/band_fields.h"
#include "tests/robot_app/monitoring/fields_fixture.h"

namespace coppice::robot::monitoring {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::HasSubstr;

class WatchFieldsTest : public FieldsTest {};

TEST_F(WatchFieldsTest, ANodeHasTheMissesOfItsListUnlessItSaysOthers) {
  YamlFields plain = Open("node: /base");
  EXPECT_EQ(ReadNodeWatch(plain, 3).misses, 3);
  YamlFields own = Open("{node: /base, misses: 5}");
  EXPECT_EQ(ReadNodeWatch(own, 3).misses, 5);
  EXPECT_EQ(Errors(), "");
}

TEST_F(WatchFieldsTest, ATopicThatIsTakenFromStatisticsMayBeSilentForLonger) {
  YamlFields subscribed = Open("{topic: /scan, node: /laser, error: [5, none]}");
  const TopicWatch scan = ReadTopicWatch(subscribed, 2);
  EXPECT_EQ(scan.band.staleness, seconds(2));
  EXPECT_EQ(scan.window, seconds(2));
  EXPECT_FALSE(scan.by_statistics);
  EXPECT_FALSE(scan.wall_time);
  YamlFields statistics =
      Open("{topic: /cloud, node: /camera, by: statistics, time: wall, error: [5, none]}");
  const TopicWatch cloud = ReadTopicWatch(statistics, 2);
  EXPECT_EQ(cloud.band.staleness, seconds(10));
  EXPECT_TRUE(cloud.by_statistics);
  EXPECT_TRUE(cloud.wall_time);
  EXPECT_EQ(Errors(), "");
}

TEST_F(WatchFieldsTest, NavigationAndLocalizationHaveDefaultsForAllTheirTimes) {
  YamlFields navigation = Open("{topic: /navigation/state, node: /move_base, no_path: 2.5}");
  const NavigationWatch moves = ReadNavigationWatch(navigation);
  EXPECT_EQ(moves.blocked, seconds(60));
  EXPECT_EQ(moves.no_path, milliseconds(2500));
  EXPECT_EQ(moves.after_failure, seconds(15));
  YamlFields localization = Open("{topic: /localization/state, node: /localization}");
  const LocalizationWatch pose = ReadLocalizationWatch(localization);
  EXPECT_EQ(pose.staleness, seconds(3));
  EXPECT_EQ(pose.since_confirmed, AtMost(10, 20));
  EXPECT_EQ(pose.score.warn, (Range{0.3, std::nullopt}));
  EXPECT_EQ(pose.score.error, Range{}) << "whether it is lost, the localization knows best";
  EXPECT_EQ(Errors(), "");
}

TEST_F(WatchFieldsTest, ATransformNeedsItsFramesOnly) {
  YamlFields fields = Open("{parent: map, child: odom, speed: 1.5}");
  const TransformWatch watch = ReadTransformWatch(fields);
  EXPECT_EQ(watch.parent + watch.child + watch.node, "mapodom");
  EXPECT_EQ(watch.age.staleness, seconds(3));
  EXPECT_EQ(watch.speed, 1.5);
  EXPECT_EQ(Errors(), "");
  YamlFields none = Open("{parent: map}");
  ReadTransformWatch(none);
  EXPECT_THAT(Errors(), HasSubstr("\"child\""));
}

TEST_F(WatchFieldsTest, ALoggerIsAFileOrATopic) {
  YamlFields file = Open("{name: record, path: run.coppice}");
  EXPECT_EQ(ReadLoggerWatch(file).staleness, seconds(60));
  YamlFields topic = Open("{name: bag, topic: /recorder/status, staleness: 5}");
  EXPECT_EQ(ReadLoggerWatch(topic).topic, "/recorder/status");
  EXPECT_EQ(Errors(), "");
  YamlFields both = Open("{name: bag, topic: /recorder/status, path: run.bag}");
  ReadLoggerWatch(both);
  EXPECT_THAT(Errors(), HasSubstr("either \"path\" or \"topic\""));
}

TEST_F(WatchFieldsTest, ALoggerThatIsNeitherIsAnError) {
  YamlFields neither = Open("{name: bag}");
  ReadLoggerWatch(neither);
  EXPECT_THAT(Errors(), HasSubstr("either \"path\" or \"topic\""));
}

TEST_F(WatchFieldsTest, SourcesAndDiagnosticsHaveDefaults) {
  YamlFields source = Open("{source: /system_monitor, host: arm}");
  const SourceWatch monitor = ReadSourceWatch(source);
  EXPECT_EQ(monitor.period, milliseconds(500));
  EXPECT_EQ(monitor.host, "arm");
  YamlFields diagnostics = Open("{}");
  EXPECT_EQ(ReadDiagnosticsWatch(diagnostics).staleness, seconds(5));
  EXPECT_EQ(Errors(), "");
}

TEST_F(WatchFieldsTest, WhatNobodyAskedForIsAnErrorWithItsPlace) {
  YamlFields fields = Open("node: /base\nmises: 5\n");
  ReadNodeWatch(fields, 3);
  EXPECT_THAT(Errors(), HasSubstr("fields.yaml:2:"));
  EXPECT_THAT(Errors(), HasSubstr("unknown key \"mises\""));
}

}  // namespace
}  // namespace coppice::robot::monitoring
