// The program with a real ROS graph, a real PostgreSQL server and the real monitor of loggers.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gmock/gmock.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/BatteryState.h>
#include <sensor_msgs/PointCloud2.h>
#include <sys/wait.h>

#include <filesystem>

#include "tests/robot_app/monitoring/monitor_graph.h"
#include "tests/robot_app/storage/local_postgres.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::storage {
namespace {

using monitoring::HealthEntry;
using processes::kPrograms;
using testing::HasSubstr;
using testing::StartsWith;

constexpr char kMonitors[] = R"(
report_period: 0.1
initial: operating
configurations:
  operating:
    loggers: [{name: store, topic: /store/status, node: /store, staleness: 3}]
    diagnostics: {staleness: 5}
    sources: [{source: /topic_monitor, period: 0.5}]
)";

class StoreProgramTest : public monitoring::MonitorGraphTest {
 protected:
  StoreProgramTest() : MonitorGraphTest(kMonitors) {
    WriteFile(config_file_, "robot: sobi\nserver: {host: " + postgres_.owner().host +
                                ", port: " + std::to_string(postgres_.owner().port) +
                                ", database: postgres, user: owner, tls: none}\n"
                                "spool: {folder: " +
                                folder_.Path("spool") +
                                "}\n"
                                "topics:\n"
                                "  - {topic: /battery_state, priority: 9}\n"
                                "  - {topic: /cloud, left_out: file}\n");
    battery_ = graph_.node().advertise<sensor_msgs::BatteryState>("/battery_state", 100, true);
    cloud_ = graph_.node().advertise<sensor_msgs::PointCloud2>("/cloud", 100, true);
  }

  int StartStore() {
    return graph_.Start("store", {kPrograms + "coppice-store", "run", "--config", config_file_});
  }
  // Runs an export to its end.
  int Export(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{kPrograms + "coppice-store", "export", "--config",
                                     config_file_};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return graph_.WaitForEnd(graph_.Start("export", command)).value_or(-1);
  }
  bool WaitForRows(const std::string& topic, const std::string& count) {
    return graph_.WaitFor([&] {
      try {
        return postgres_.AskOne("SELECT count(*) FROM coppice.messages WHERE topic = '" + topic +
                                "'") == count;
      } catch (const std::exception&) {
        return false;  // there is no table yet
      }
    });
  }

  const TemporaryFolder folder_;
  const std::string config_file_ = folder_.Path("store.yaml");
  LocalPostgres postgres_;
  ros::Publisher battery_, cloud_;
};

TEST_F(StoreProgramTest, StoresWhatIsSentIsWatchedAndGivesItBack) {
  StartMonitor("topic-monitor");
  const int store = StartStore();
  ASSERT_TRUE(graph_.WaitFor(
      [this] { return battery_.getNumSubscribers() > 0 && cloud_.getNumSubscribers() > 0; }));
  sensor_msgs::BatteryState battery;
  battery.percentage = 0.5F;
  for (int i = 0; i < 50; ++i) {
    battery.voltage = static_cast<float>(i);
    battery_.publish(battery);
  }
  sensor_msgs::PointCloud2 cloud;
  cloud.data.resize(5000, 7);
  cloud_.publish(cloud);
  EXPECT_TRUE(WaitForRows("/battery_state", "50"));
  EXPECT_TRUE(WaitForRows("/cloud", "1"));
  EXPECT_EQ(postgres_.AskOne("SELECT count(*), max(voltage), min(charge) FROM coppice.battery"),
            "50|49|0.5");

  const std::string bag_path = folder_.Path("out.bag");
  ASSERT_EQ(Export({"--output", bag_path, "--files", folder_.Path("spool/files")}), 0);
  const rosbag::Bag bag(bag_path);
  rosbag::View view(bag);
  EXPECT_EQ(view.size(), 51u);
  for (const rosbag::MessageInstance& message : view) {
    if (const auto stored = message.instantiate<sensor_msgs::PointCloud2>()) {
      EXPECT_EQ(stored->data, cloud.data);
    }
  }
  const std::string table_path = folder_.Path("out.csv");
  const std::string others_file = folder_.Path("others");  // laid in the way by somebody
  WriteFile(others_file, "whole");
  std::filesystem::create_symlink(others_file, table_path + ".part");
  ASSERT_EQ(Export({"--output", table_path, "--topic", "/battery_state"}), 0);
  EXPECT_THAT(ReadFile(table_path), StartsWith("time,stamp,header.seq,header.stamp,"));
  EXPECT_NE(Export({"--output", folder_.Path("both.csv")}), 0);
  EXPECT_EQ(ReadFile(folder_.Path("both.csv")), "");
  EXPECT_EQ(ReadFile(others_file), "whole");

  // A server that makes up a type whose fields multiply, and end in nothing.
  std::string definition = "K0 k\n";
  for (int i = 0; i < 20; ++i) {
    definition += "MSG: a/K" + std::to_string(i) + "\n";
    for (const char* const field : {" a\n", " b\n", " c\n", " d\n"}) {
      definition += "K" + std::to_string(i + 1) + field;
    }
  }
  postgres_.Ask("INSERT INTO coppice.types VALUES ('a/B', '5', '" + definition + "MSG: a/K20\n')");
  postgres_.Ask(
      "INSERT INTO coppice.messages VALUES ('sobi', 's', 1, now(), 1, '/made_up', 'a/B', '5', '{}')");
  const int made_up = Export({"--output", folder_.Path("made_up.csv"), "--topic", "/made_up"});
  EXPECT_EQ(WEXITSTATUS(made_up), 1);

  EXPECT_TRUE(WaitForLevel("logger", "store", HealthEntry::OK));
  EXPECT_TRUE(WaitForLevel("diagnostics", "coppice_store: spool", HealthEntry::OK));
  postgres_.Stop();
  battery_.publish(battery);
  EXPECT_TRUE(WaitForLevel("diagnostics", "coppice_store: server", HealthEntry::WARN));
  EXPECT_EQ(Find("logger", "store")->level, HealthEntry::OK);  // it keeps messages meanwhile
  processes::RosGraph::Hang(store);
  EXPECT_TRUE(WaitForLevel("logger", "store", HealthEntry::ERROR));
  EXPECT_EQ(Find("logger", "store")->node, "/store");
}

}  // namespace
}  // namespace coppice::robot::storage
