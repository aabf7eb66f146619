// What becomes of exceptions under each ExceptionPolicy.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

using Names = std::vector<std::string>;
constexpr Status kRunning = Status::kRunning;

class Group : public UserControl {
 public:
  static constexpr const char* kDescription = "Ticks its first child.";
  Status Tick(Children& children, bool) override { return children.Tick(0); }
};

// "runs" is RUNNING when "throws" throws in the second tick; the Parallel is in the midst of its
// children then.
struct Throwing {
  explicit Throwing(ExceptionPolicy policy) : stage(Text(), Script()) {
    stage.script.on_tick["throws"] = [this] {
      if (++ticks == 2) throw std::runtime_error("no map");
    };
    executor = std::make_unique<Executor>(stage.program, stage.clock, ExecutorOptions{policy});
  }
  static std::string Text() {
    return Main(R"(<Parallel name="all" failure_count="2"><Leaf name="runs"/>)"
                R"(<ForceSuccess><Leaf name="throws"/></ForceSuccess></Parallel>)");
  }
  static LeafScript Script() {
    LeafScript script;
    script.results["runs"] = {kRunning};
    script.results["throws"] = {kRunning};
    return script;
  }
  int ticks = 0;
  Stage stage;
  std::unique_ptr<Executor> executor;
};

TEST(ExceptionPolicy, FailNodeLetsTheTreeGoOn) {
  Throwing tree(ExceptionPolicy::kFailNode);
  tree.executor->Tick();
  EXPECT_EQ(tree.executor->Tick(), kRunning);
  EXPECT_EQ(tree.executor->statuses()[1], kRunning);
}

TEST(ExceptionPolicy, HaltTreeHaltsEverythingAndFails) {
  Throwing tree(ExceptionPolicy::kHaltTree);
  tree.executor->Tick();
  tree.stage.TakeEvents();
  EXPECT_EQ(tree.executor->Tick(), Status::kFailure);
  EXPECT_EQ(tree.stage.TakeEvents(),
            (Names{"tick runs", "tick throws", "halt runs", "halt throws"}));
  for (const Status status : tree.executor->statuses()) EXPECT_EQ(status, Status::kIdle);
}

TEST(ExceptionPolicy, HaltTreeSaysWhichNodeAndWhy) {
  Throwing tree(ExceptionPolicy::kHaltTree);
  KeepingSink sink;
  tree.executor->AddSink(&sink);
  tree.executor->Tick();
  tree.executor->Tick();
  ASSERT_EQ(sink.ticks[1].messages.size(), 1U);
  EXPECT_EQ(sink.ticks[1].messages[0].node, 3U);
  EXPECT_EQ(sink.ticks[1].messages[0].text, "no map");
  EXPECT_EQ(sink.ticks[1].result, Status::kFailure);
  tree.executor->RemoveSink(&sink);
}

TEST(ExceptionPolicy, RethrowNamesThePathAndKeepsTheOriginal) {
  Throwing tree(ExceptionPolicy::kRethrow);
  tree.executor->Tick();
  try {
    tree.executor->Tick();
    FAIL() << "nothing was thrown";
  } catch (const TickError& error) {
    EXPECT_STREQ(error.what(), "throws: no map");
    EXPECT_EQ(error.node, 3U);
    EXPECT_THROW(std::rethrow_if_nested(error), std::runtime_error);
  }
  for (const Status status : tree.executor->statuses()) EXPECT_EQ(status, Status::kIdle);
}

TEST(ExceptionPolicy, ATreeThatThrewStartsAgain) {
  Throwing tree(ExceptionPolicy::kRethrow);
  tree.executor->Tick();
  EXPECT_THROW(tree.executor->Tick(), TickError);
  tree.stage.TakeEvents();
  EXPECT_EQ(tree.executor->Tick(), kRunning);
  EXPECT_EQ(tree.stage.TakeEvents(), (Names{"start runs", "start throws"}));
}

TEST(ExceptionPolicy, AnExceptionPassesThroughControlNodesOfTheUser) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Group>("Group");
  registry->Action("Bad", []() -> Status { throw std::runtime_error("bad"); });
  Diagnostics diagnostics;
  const auto program = CompileText(Main("<Group><Bad name=\"b\"/></Group>"), diagnostics, registry);
  ASSERT_TRUE(program) << diagnostics.ToString();
  SimulatedClock clock;
  Executor executor(program, clock, {ExceptionPolicy::kRethrow});
  try {
    executor.Tick();
    FAIL() << "nothing was thrown";
  } catch (const TickError& error) {
    EXPECT_STREQ(error.what(), "b: bad");
  }
}

}  // namespace
}  // namespace coppice
