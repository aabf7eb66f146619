#include "robot_app/common/node_probe.h"

#include <gmock/gmock.h>

#include <csignal>

#include "tests/robot_app/processes/ros_graph.h"

namespace coppice::robot {
namespace {

using std::chrono::milliseconds;

TEST(ParseUri, TakesHostAndPort) {
  const auto address = ParseUri("http://robot:11311/");
  ASSERT_TRUE(address.has_value());
  EXPECT_EQ(address->host, "robot");
  EXPECT_EQ(address->port, 11311);
  EXPECT_TRUE(ParseUri("http://127.0.0.1:5").has_value());
}

TEST(ParseUri, RefusesWhatIsNoAddress) {
  for (const char* uri : {"", "robot:11311", "http://:1", "http://robot", "http://robot:x",
                          "http://robot:", "http://robot:70000", "http://robot:99999999999"}) {
    EXPECT_FALSE(ParseUri(uri).has_value()) << uri;
  }
}

class NodeProbeTest : public testing::Test {
 protected:
  std::vector<ProbeResult> Sweep(std::vector<ProbeRequest> requests, Duration deadline) {
    NodeProbe probe(graph_.master(), "/test");
    probe.Begin(std::move(requests), deadline);
    while (!probe.Work(milliseconds(20))) {
    }
    return probe.results();
  }
  int StartTalker(const std::string& name) {
    const int pid = graph_.Start(name, {processes::kTestPrograms + "test_talker", "__name:=" + name,
                                        "_topic:=/" + name + "/talk"});
    EXPECT_TRUE(graph_.WaitFor([&] {
      return Sweep({{"/" + name, "/" + name + "/talk"}}, milliseconds(500))[0].answered;
    }));
    return pid;
  }
  processes::RosGraph graph_;
};

TEST_F(NodeProbeTest, ALivingNodeTellsItsPidAndWhatItPublishes) {
  const int pid = StartTalker("a");
  const auto results =
      Sweep({{"/a", ""}, {"/a", "/a/talk"}, {"/a", "/other"}, {"/nobody", ""}}, milliseconds(500));
  EXPECT_TRUE(results[0].answered);
  EXPECT_EQ(results[0].pid, pid);
  EXPECT_GT(results[0].delay, Duration::zero());
  EXPECT_TRUE(results[1].answered);
  EXPECT_FALSE(results[2].answered);
  EXPECT_EQ(results[2].reason, "does not publish /other");
  EXPECT_EQ(results[3].reason, "unknown to the ROS master");
}

TEST_F(NodeProbeTest, AKilledNodeRefusesAndManyHungNodesCostOneDeadline) {
  const int killed = StartTalker("a");
  graph_.Kill(killed, SIGKILL);
  const int hung_1 = StartTalker("b"), hung_2 = StartTalker("c"), hung_3 = StartTalker("d");
  StartTalker("e");
  for (const int pid : {hung_1, hung_2, hung_3}) graph_.Hang(pid);
  const auto begin = std::chrono::steady_clock::now();
  const auto results =
      Sweep({{"/a", ""}, {"/b", ""}, {"/c", ""}, {"/d", ""}, {"/e", ""}}, milliseconds(2000));
  const auto took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(results[0].reason, "refuses connections");
  for (const int i : {1, 2, 3}) EXPECT_EQ(results[i].reason, "does not answer");
  EXPECT_TRUE(results[4].answered);
  EXPECT_GE(took, milliseconds(2000));
  EXPECT_LT(took, milliseconds(6000));  // not three deadlines
}

TEST_F(NodeProbeTest, ANodeThatWasStartedAgainIsFoundAtItsNewAddressInTheSameSweep) {
  NodeProbe probe(graph_.master(), "/test");
  const auto sweep = [&probe] {
    probe.Begin({{"/a", ""}}, milliseconds(2000));
    while (!probe.Work(milliseconds(20))) {
    }
    return probe.results().at(0);
  };
  const int first = StartTalker("a");
  for (unsigned i = 0; i < 2 * NodeProbe::kSweepsPerLookup; ++i) EXPECT_EQ(sweep().pid, first);
  graph_.Kill(first, SIGKILL);
  EXPECT_EQ(sweep().reason, "refuses connections");
  EXPECT_EQ(sweep().reason, "refuses connections");
  int before = StartTalker("a");
  EXPECT_EQ(sweep().pid, before);
  for (int i = 0; i < 3; ++i) {  // whenever the master would have been asked
    graph_.Kill(before, SIGKILL);
    before = StartTalker("a");
    EXPECT_EQ(sweep().pid, before);
    EXPECT_EQ(sweep().pid, before);
  }
}

TEST(NodeProbe, SaysThatThereIsNoMaster) {
  NodeProbe::SilenceLibrary();
  NodeProbe probe({"127.0.0.1", processes::FreePort()}, "/test");
  probe.Begin({{"/a", ""}}, milliseconds(500));
  EXPECT_TRUE(probe.busy());
  while (!probe.Work(milliseconds(20))) {
  }
  EXPECT_FALSE(probe.busy());
  EXPECT_EQ(probe.results()[0].reason, "the ROS master refuses connections");
}

}  // namespace
}  // namespace coppice::robot
