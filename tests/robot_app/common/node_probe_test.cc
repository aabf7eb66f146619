#include "robot_app/common/node_probe.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpc.h>

#include <csignal>
#include <functional>
#include <thread>

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

// A node, or a master, that says what it likes.
class Liar {
 public:
  using Answer = std::function<std::string(const std::string& question)>;
  explicit Liar(Answer answer) : answer_(std::move(answer)), listener_(Listen()) {
    thread_ = std::thread([this] { Serve(); });
  }
  ~Liar() {
    shutdown(listener_, SHUT_RDWR);
    thread_.join();
    close(listener_);
  }
  Liar(const Liar&) = delete;

  int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof(address);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

 private:
  static int Listen() {
    const int listener = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    bind(listener, reinterpret_cast<sockaddr*>(&address), sizeof(address));
    listen(listener, 10);
    return listener;
  }

  void Serve() const {
    for (int client; (client = accept(listener_, nullptr, nullptr)) >= 0;) {
      const timeval patience{5, 0};
      setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof(patience));
      char question[4096];
      const ssize_t size = read(client, question, sizeof(question));
      if (size > 0) {
        const std::string answer = answer_({question, static_cast<std::size_t>(size)});
        const std::string head = "HTTP/1.1 200 OK\r\nContent-Type: text/xml\r\nContent-Length: ";
        const std::string all = head + std::to_string(answer.size()) + "\r\n\r\n" + answer;
        send(client, all.data(), all.size(), MSG_NOSIGNAL);
      }
      shutdown(client, SHUT_WR);
      while (read(client, question, sizeof(question)) > 0) {
      }
      close(client);
    }
  }

  const Answer answer_;
  const int listener_;
  std::thread thread_;
};

std::string Response(const std::string& value) {
  return "<?xml version=\"1.0\"?><methodResponse><params><param><value>" + value +
         "</value></param></params></methodResponse>";
}

std::string Repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(NodeProbe, WhateverAMasterAnswersEndsNothing) {
  NodeProbe::SilenceLibrary();
  const std::string deep = Repeated("<array><data><value>", 50'000);
  const std::string value = "<value><int>1</int></value>";
  const auto triple = [&](const std::string& what) {
    return Response("<array><data>" + value + "<value>x</value><value>" + what +
                    "</value></data></array>");
  };
  for (const std::string& answer :
       {std::string("no XML"), Response(deep), Response("<int>3</int>"), Response("<int>x</int>"),
        Response(deep + Repeated("</value></data></array>", 50'000)), triple("http://127.0.0.1:0"),
        triple("<array><data><value><array><data>" + value +
               "</data></array></value></data></array>"),
        Response(std::string(std::size_t{20} << 20, 'x'))}) {
    const Liar liar([&answer](const std::string&) { return answer; });
    NodeProbe probe({"127.0.0.1", liar.port()}, "/test");
    probe.Begin({{"/a", "/a/talk"}}, milliseconds(3000));
    while (!probe.Work(milliseconds(20))) {
    }
    EXPECT_FALSE(probe.results()[0].answered) << answer.substr(0, 200);
  }
}

TEST_F(NodeProbeTest, WhateverANodeAnswersEndsNothing) {
  const std::string one = "<value><int>1</int></value>";
  const std::string begin = "<array><data>" + one + one;
  const Liar liar([&](const std::string& question) {
    const bool wants_topics = question.find("getPublications") != std::string::npos;
    const std::string list = "<value><array><data>" + one + "</data></array></value>";
    return Response(
        begin + (wants_topics ? "<value><array><data>" + list + "</data></array></value>" : one) +
        "</data></array>");
  });
  XmlRpc::XmlRpcClient master(graph_.master().host.c_str(), graph_.master().port, "/");
  XmlRpc::XmlRpcValue request, answer;
  request[0] = "/liar";
  request[1] = "/liar/talk";
  request[2] = "std_msgs/String";
  request[3] = "http://127.0.0.1:" + std::to_string(liar.port());
  ASSERT_TRUE(master.execute("registerPublisher", request, answer));
  const ProbeResult result = Sweep({{"/liar", "/liar/talk"}}, milliseconds(3000))[0];
  EXPECT_EQ(result.pid, 1);
  EXPECT_EQ(result.reason, "does not publish /liar/talk");
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
