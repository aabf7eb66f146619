#include "robot_app/app/tree_runner.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <filesystem>
#include <future>
#include <mutex>

#include "bt_core/record/record_reader.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/eventually.h"

namespace coppice::robot {
namespace {

constexpr char kTree[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main">
  <Repeat num_cycles="{rounds}"><Delay delay_msec="1"><AlwaysSuccess/></Delay></Repeat>
</BehaviorTree></root>)";

std::shared_ptr<const Program> MakeProgram() {
  Diagnostics diagnostics;
  auto project = Project::FromText(kTree, "runner", diagnostics);
  return Compile(std::make_shared<const Project>(*std::move(project)),
                 std::make_shared<const Registry>(), diagnostics);
}

class TreeRunnerTest : public testing::Test {
 protected:
  TreeRunnerTest() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    options_.name = "application";
    options_.record_path = (folder_ / "application.coppice").string();
  }
  ~TreeRunnerTest() override { std::filesystem::remove_all(folder_); }

  // Runs the tree for some rounds; returns the root's last result.
  Status RunRounds(const std::string& rounds) {
    TreeRunner runner(MakeProgram(), clock_, options_);
    EXPECT_EQ(SetKey(runner.executor(), "rounds", rounds).problem(), "");
    std::mutex mutex;
    std::condition_variable ended;
    Status result = Status::kIdle;
    runner.Start([&](Status status) {
      const std::lock_guard<std::mutex> lock(mutex);
      result = status;
      ended.notify_one();
    });
    std::unique_lock<std::mutex> lock(mutex);
    ended.wait_for(lock, std::chrono::seconds(10), [&] { return result != Status::kIdle; });
    return result;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("tree_runner_test_" + std::to_string(getpid()));
  SimulatedClock clock_{std::chrono::seconds(1)};
  TreeRunnerOptions options_;
};

TEST_F(TreeRunnerTest, TellsHowTheTreeEnded) { EXPECT_EQ(RunRounds("3"), Status::kSuccess); }

TEST_F(TreeRunnerTest, LeavesARecordThatWasClosedInOrder) {
  RunRounds("3");
  Diagnostics diagnostics;
  auto reader = RecordReader::Open(options_.record_path, diagnostics);
  ASSERT_TRUE(reader) << diagnostics.ToString();
  EXPECT_TRUE(reader->closed());
}

TEST_F(TreeRunnerTest, StartsASecondRecordBesideAnEarlierOne) {
  RunRounds("1");
  RunRounds("1");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "application.2.coppice"));
}

TEST_F(TreeRunnerTest, StopsATreeThatRunsForEver) {
  options_.run.forever = true;
  TreeRunner runner(MakeProgram(), clock_, options_);
  EXPECT_TRUE(SetKey(runner.executor(), "rounds", "-1"));
  bool ended = false;
  runner.Start([&](Status) { ended = true; });
  runner.Stop();
  EXPECT_FALSE(ended) << "a tree that was stopped has not completed";
}

// A program of somebody else that has the port must not end the robot.
TEST_F(TreeRunnerTest, RunsWithoutALiveSocketWhosePortIsTakenAndSaysSo) {
  options_.live_port = processes::FreePort(2);
  const TreeRunner first(MakeProgram(), clock_, options_);
  EXPECT_EQ(RunRounds("3"), Status::kSuccess);
  const TreeRunner second(MakeProgram(), clock_, options_);
  EXPECT_NE(second.LiveTrouble().find(std::to_string(options_.live_port)), std::string::npos)
      << second.LiveTrouble();
  EXPECT_EQ(first.LiveTrouble(), "");
}

TEST_F(TreeRunnerTest, RunsWithoutARecordThatCannotBeMadeAndSaysSo) {
  options_.record_path = "/proc/nowhere/application.coppice";
  EXPECT_EQ(RunRounds("3"), Status::kSuccess);
  const TreeRunner runner(MakeProgram(), clock_, options_);
  EXPECT_NE(runner.RecordTrouble().find("/proc/nowhere"), std::string::npos);
}

TEST(SetKey, RefusesAKeyThatTheTreeDoesNotUseAndNamesTheNearest) {
  SimulatedClock clock;
  Executor executor(MakeProgram(), clock);
  EXPECT_EQ(SetKey(executor, "round", "3").problem(),
            "the tree has no key \"round\" did you mean \"rounds\"?");
}

TEST(SetKey, RefusesAValueOfAnotherType) {
  SimulatedClock clock;
  Executor executor(MakeProgram(), clock);
  EXPECT_EQ(SetKey(executor, "rounds", "many").problem(),
            "\"many\" is not a value for key \"rounds\", expected int");
}

// Asks as a heartbeat does, but faster.
bool ComesToLife(TreeRunner& runner) {
  return Eventually([&] { return runner.IsAlive(); });
}

// Is not alive in a hundred looks at a tree that is known to stand.
bool LooksDead(TreeRunner& runner) {
  runner.IsAlive();
  for (int i = 0; i < 100; ++i) {
    if (runner.IsAlive()) return false;
  }
  return true;
}

// A leaf that holds up the thread of its tree until the test lets it go.
class Blocking : public SyncAction {
 public:
  static constexpr const char* kDescription = "Blocks.";
  Blocking(std::promise<void>* entered, std::shared_future<void> release)
      : entered_(entered), release_(std::move(release)) {}
  Status Run() override {
    entered_->set_value();
    release_.wait();
    return Status::kSuccess;
  }

 private:
  std::promise<void>* entered_;
  std::shared_future<void> release_;
};

TEST_F(TreeRunnerTest, ATreeWhoseThreadIsHeldUpByALeafIsNotAlive) {
  std::promise<void> entered, release;
  const auto registry = std::make_shared<Registry>();
  registry->Register<Blocking>("Blocking", &entered, release.get_future().share());
  Diagnostics diagnostics;
  auto project = Project::FromText(
      R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Blocking/></BehaviorTree></root>)",
      "runner", diagnostics);
  const auto program =
      Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  TreeRunner runner(program, clock_, options_);
  runner.Start([](Status) {});
  entered.get_future().wait();
  EXPECT_TRUE(LooksDead(runner));
  release.set_value();
  EXPECT_TRUE(ComesToLife(runner));
}

// As that of a simulation that has been stopped.
class StandingClock : public Clock {
 public:
  Time Now() const override { return Time(std::chrono::seconds(1)); }
  void WaitUntil(Time, WakeUp& wake_up) override { wake_up.WaitFor(Duration::max()); }
};

TEST_F(TreeRunnerTest, ATreeThatWaitsForATimeThatDoesNotComeIsAlive) {
  StandingClock clock;
  TreeRunner runner(MakeProgram(), clock, options_);
  EXPECT_TRUE(SetKey(runner.executor(), "rounds", "-1"));
  runner.Start([](Status) {});
  runner.IsAlive();
  EXPECT_TRUE(ComesToLife(runner));
}

// A tree that counts its beginnings and then runs for ever.
constexpr char kCounting[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <Script code="begun += 1"/><Sleep msec="1000000000"/>
</Sequence></BehaviorTree></root>)";

TEST_F(TreeRunnerTest, RestsWhileItIsSuspendedAndThenBeginsAnew) {
  Diagnostics diagnostics;
  auto project = Project::FromText(kCounting, "runner", diagnostics);
  const auto program = Compile(std::make_shared<const Project>(*std::move(project)),
                               std::make_shared<const Registry>(), diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  options_.record_path.clear();
  TreeRunner runner(program, clock_, options_);
  EXPECT_EQ(SetKey(runner.executor(), "begun", "0").problem(), "");
  std::mutex mutex;
  std::condition_variable changed;
  int begun = 0;
  // Between two ticks, on the tree's thread.
  const auto look = [&] {
    const Executor& executor = runner.executor();
    const std::lock_guard<std::mutex> lock(mutex);
    const Value& value =
        executor.blackboard()[executor.program().layout.Find(kMainScope, "begun")].value;
    begun = value.has_value() ? static_cast<int>(value.Get<std::int64_t>()) : 0;
    changed.notify_one();
  };
  const auto wait_for = [&](int times) {
    std::unique_lock<std::mutex> lock(mutex);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (begun < times && std::chrono::steady_clock::now() < deadline) {
      runner.executor().inbox()->PostCall(look);
      changed.wait_for(lock, std::chrono::milliseconds(20));
    }
    return begun;
  };
  runner.Start([](Status) {});
  EXPECT_EQ(wait_for(1), 1);
  runner.Suspend();
  runner.Resume();
  EXPECT_EQ(wait_for(2), 2);
  runner.Suspend();
  runner.Stop();  // also while it rests
  EXPECT_NE(runner.executor().status(kRootNode), Status::kRunning);
}

}  // namespace
}  // namespace coppice::robot
