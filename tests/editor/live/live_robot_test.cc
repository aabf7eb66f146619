// The client against the engine's own publisher: a real tree, real sockets, no other program.
#include <gtest/gtest.h>

#include <chrono>

#include "bt_core/engine/executor.h"
#include "bt_core/live/live_publisher.h"
#include "editor/live/live_client.h"
#include "editor/scene/scene.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main">
    <Sequence name="top">
      <WriteNote text="{note}"/>
      <SubTree ID="Sub" name="inner" heard="{note}"/>
    </Sequence>
  </BehaviorTree>
  <BehaviorTree ID="Sub">
    <Fallback><AlwaysFailure/>
      <Delay delay_msec="60000"><ReadNote text="{heard}"/></Delay></Fallback>
  </BehaviorTree>
</root>)";

class WriteNote : public SyncAction {
 public:
  static constexpr const char* kDescription = "Writes a note.";
  Output<std::string> text{this, "text", "where to"};
  Status Run() override {
    text.Set("milk");
    return Status::kSuccess;
  }
};

class ReadNote : public SyncAction {
 public:
  static constexpr const char* kDescription = "Reads a note.";
  Input<std::string> text{this, "text", "where from"};
  Status Run() override { return Status::kSuccess; }
};

class LiveRobotTest : public testing::Test {
 protected:
  LiveRobotTest() {
    auto registry = std::make_shared<Registry>();
    registry->Register<WriteNote>("WriteNote");
    registry->Register<ReadNote>("ReadNote");
    Diagnostics diagnostics;
    auto project = Project::FromText(kTree, "robot.xml", diagnostics);
    program_ = Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
    EXPECT_NE(program_, nullptr) << diagnostics.ToString();
  }

  // Ticks the robot until the client knows what is asked for.
  template <class Condition>
  bool TickUntil(Executor& executor, const LiveClient& client, Condition condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(15);
    while (!condition(*client.snapshot())) {
      if (std::chrono::steady_clock::now() > end) return false;
      executor.RunCalls();
      executor.Tick();
    }
    return true;
  }

  std::shared_ptr<const Program> program_;
  SimulatedClock robot_clock_;
  WallClock clock_;
};

LiveOptions AnyPort() {
  LiveOptions options;
  options.port = 0;
  return options;
}

TEST_F(LiveRobotTest, ShowsTheTreeTheStatusesAndTheValuesOfARunningProgram) {
  Executor executor(program_, robot_clock_);
  EventStream stream(executor);
  LivePublisher publisher(stream, AnyPort());
  LiveClient client("127.0.0.1:" + std::to_string(publisher.port()), clock_);
  ASSERT_TRUE(TickUntil(executor, client, [](const LiveSnapshot& s) {
    return s.connection == Connection::kLive && !s.states.empty();
  })) << client.snapshot()->error;

  const auto tree = client.snapshot()->tree;
  EXPECT_FALSE(tree->problems.has_errors()) << tree->problems.ToString();
  NodeModels models;
  models.AddFrom(*tree->forest.documents()[0]);
  const Scene scene = BuildScene(tree->forest, tree->forest.main_tree(), models);
  EXPECT_EQ(scene.tree_id, "Main");
  const auto status = [&](const char* path) {
    const SceneNode& node = scene.nodes[scene.FindPath(path)];
    return client.snapshot()->states[static_cast<std::size_t>(node.uid)].status;
  };
  EXPECT_EQ(status("1"), Status::kRunning);
  EXPECT_EQ(status("1.1"), Status::kSuccess);
  EXPECT_EQ(status("1.2.1.1"), Status::kFailure);
  EXPECT_EQ(status("1.2.1.2"), Status::kRunning);
  EXPECT_EQ(scene.nodes[scene.FindPath("1.1")].shape, Shape::kAction);
  EXPECT_NE(models.Find("WriteNote")->FindPort("text"), nullptr);

  client.Watch(scene.scopes);
  ASSERT_TRUE(TickUntil(executor, client, [](const LiveSnapshot& s) { return !s.boards.empty(); }));
  const auto boards = client.snapshot()->boards;
  EXPECT_EQ(boards[0].name, "Main");
  EXPECT_EQ(boards[0].entries[0].key, "note");
  EXPECT_EQ(boards[0].entries[0].value, "\"milk\"");
}

TEST_F(LiveRobotTest, FollowsARobotThatIsStartedAgain) {
  std::string endpoint;
  std::uint16_t port = 0;
  std::unique_ptr<LiveClient> client;
  LiveClientOptions quick;
  quick.reply_timeout = std::chrono::milliseconds(200);
  quick.first_pause = quick.longest_pause = std::chrono::milliseconds(20);
  {
    Executor executor(program_, robot_clock_);
    EventStream stream(executor);
    LivePublisher publisher(stream, AnyPort());
    port = publisher.port();
    client = std::make_unique<LiveClient>("127.0.0.1:" + std::to_string(port), clock_,
                                          std::function<void()>(), quick);
    ASSERT_TRUE(
        TickUntil(executor, *client, [](const LiveSnapshot& s) { return s.sessions == 1; }));
  }
  Executor executor(program_, robot_clock_);
  LiveOptions same;
  same.port = port;
  EventStream stream(executor);
  LivePublisher publisher(stream, same);
  EXPECT_TRUE(TickUntil(executor, *client, [](const LiveSnapshot& s) {
    return s.sessions == 2 && s.connection == Connection::kLive;
  })) << client->snapshot()->error;
}

}  // namespace
}  // namespace coppice::editor
