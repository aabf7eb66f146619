#include "bt_core/analysis/why/why_not.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bt_core/analysis/asked_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

TEST(WhyNot, NamesGuardsWithTheirScriptsAndValues) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='s' _skipIf='mode == 2'><AlwaysSuccess name='a'/>"
      "</Sequence></BehaviorTree>");
  run.executor.Writer<double>("mode").Send(2);
  run.Tick();
  Asked asked(run.keeper.run);
  const Why why = asked.Ask("a");
  EXPECT_EQ(why.why_not->cause, WhyNot::Cause::kOwn);
  ASSERT_EQ(why.steps.size(), 1u);
  EXPECT_EQ(why.steps[0].cause, WhyCause::kGuard);
  EXPECT_THAT(asked.Print("a"), HasSubstr(R"(s  SKIPPED  not ticked, _skipIf="mode == 2" is true: )"
                                          "mode = 2"));
}

TEST(WhyNot, KnowsWhatIsDoneAlready) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='s'><AlwaysSuccess name='a'/><Sleep name='b' "
      "msec='500'/></Sequence></BehaviorTree>");
  run.Tick();
  run.Tick();
  EXPECT_EQ(Asked(run.keeper.run).WhyNotText("a"),
            R"("s" did not tick "a" again, because it is already SUCCESS)");
}

TEST(WhyNot, KnowsWhichChildChoosesTheOthers) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><IfThenElse name='if'><AlwaysFailure name='c'/>"
      "<AlwaysSuccess name='then'/><AlwaysSuccess name='else'/></IfThenElse></BehaviorTree>");
  run.Tick();
  Asked asked(run.keeper.run);
  EXPECT_EQ(asked.WhyNotText("then"),
            R"("if" did not reach "then", because "c", which comes before it, is FAILURE)");
  EXPECT_EQ(asked.WhyNotText("else"), "it was ticked");
}

TEST(WhyNot, KnowsTicksThatWereNone) {
  RecordedRun run("<BehaviorTree ID='Main'><Sleep name='a' msec='500'/></BehaviorTree>");
  run.Tick();
  run.executor.Halt();
  EXPECT_EQ(Asked(run.keeper.run).WhyNotText("a"), "the tree was not ticked then");
}

TEST(WhyNot, NamesTheNodeThatThrewTheTickAway) {
  ExecutorOptions options;
  options.on_exception = ExceptionPolicy::kHaltTree;
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='s'><ScriptCondition name='c' code='nobody &lt; 1'/>"
      "<AlwaysSuccess name='a'/></Sequence></BehaviorTree>",
      std::make_shared<Registry>(), options);
  run.Tick();
  Asked asked(run.keeper.run);
  EXPECT_EQ(asked.Ask("a").why_not->cause, WhyNot::Cause::kAborted);
  EXPECT_EQ(asked.WhyNotText("a"), R"(an exception thrown by "c" ended the tick)");
  EXPECT_THAT(asked.Print("a"), HasSubstr("and was not ticked\nwhy not: an exception thrown by"));
}

// What a robot with the Groot2 protocol tells: changes of status, in groups that are taken for
// ticks.
class ChangesOnly {
 public:
  using Change = std::pair<NodeIndex, Status>;

  explicit ChangesOnly(bool says_so = true) : run_(kPatrol, Lamps()) {
    TreeDescription tree = run_.keeper.run.trees()[0];
    if (says_so) tree.info.metadata.emplace_back(kChangesOnly);
    told_.OnTree(tree);
    HistoryState state;
    state.statuses.assign(tree.nodes.size(), Status::kIdle);
    state.values.resize(tree.slots.size());
    told_.OnState(state);
  }
  void Tell(const std::vector<Change>& changes, Status root = Status::kRunning) {
    EventWriter words;
    for (const auto& [node, status] : changes) {
      if (status == Status::kIdle) {
        words.Reset(node);
      } else {
        words.Status(node, status);
      }
    }
    told_.OnTick({++tick_, Time{}, Duration(0), root, true, words.words()});
  }
  const Recording& run() const { return told_; }

  static constexpr NodeIndex kRoot{0}, kSafety{1}, kLow{2}, kWork{4}, kDark{5}, kDrive{6};

 private:
  RecordedRun run_;
  Recording told_;
  std::uint64_t tick_ = 0;
};

using Told = ChangesOnly;

void BeginToDrive(ChangesOnly& robot) {
  robot.Tell({{Told::kLow, Status::kFailure},
              {Told::kSafety, Status::kFailure},
              {Told::kDark, Status::kSuccess},
              {Told::kDrive, Status::kRunning},
              {Told::kWork, Status::kRunning},
              {Told::kRoot, Status::kRunning}});
}

TEST(WhyOfChanges, WhatDidNotChangeIsNotTold) {
  ChangesOnly robot;
  BeginToDrive(robot);
  robot.Tell({{Told::kDark, Status::kFailure}});
  Asked asked(robot.run());
  for (const char* node : {"root", "work", "drive", "dock"}) {
    const Why why = asked.Ask(node);
    EXPECT_TRUE(why.is_untold()) << node;
    EXPECT_FALSE(why.was_ticked) << node;
    EXPECT_TRUE(why.steps.empty()) << node;
    const std::string text = asked.Print(node);
    EXPECT_THAT(text, HasSubstr(std::string("holds status changes only, and \"") + node +
                                "\" had none; it may have been ticked"));
    EXPECT_THAT(text, testing::Not(HasSubstr("exception"))) << node;
    EXPECT_THAT(text, testing::Not(HasSubstr("not ticked"))) << node;
    EXPECT_THAT(text, HasSubstr(R"(first change: "dark" is FAILURE and was SUCCESS before)"))
        << text;
  }
  EXPECT_THAT(asked.Json("drive"), HasSubstr(R"("cause":"not_told")"));
  EXPECT_THAT(asked.Json("drive"), testing::Not(HasSubstr(R"("ticked")")));
}

TEST(WhyOfChanges, WhatChangedIsTold) {
  ChangesOnly robot;
  BeginToDrive(robot);
  robot.Tell({{Told::kDrive, Status::kSuccess},
              {Told::kWork, Status::kSuccess},
              {Told::kRoot, Status::kSuccess}},
             Status::kSuccess);
  Asked asked(robot.run());
  const Why why = asked.Ask("root");
  EXPECT_TRUE(why.was_ticked);
  ASSERT_EQ(why.steps.size(), 3U);
  EXPECT_EQ(why.steps[1].decisive, Told::kDrive);
  EXPECT_EQ(why.steps[2].before, Status::kRunning) << "what it was, told or not";
  EXPECT_TRUE(asked.Ask("dark").is_untold()) << "a reactive node ticks again what has succeeded";
}

TEST(WhyOfChanges, AnIdleNodeBehindTheOneThatDecidedWasNotTicked) {
  ChangesOnly robot;
  robot.Tell({{Told::kLow, Status::kFailure},
              {Told::kSafety, Status::kFailure},
              {Told::kDark, Status::kFailure},
              {Told::kWork, Status::kFailure},
              {Told::kRoot, Status::kFailure}},
             Status::kFailure);
  EXPECT_EQ(Asked(robot.run()).WhyNotText("drive"),
            R"("work" did not reach "drive", because "dark", which comes before it, is FAILURE)");
}

TEST(WhyOfChanges, PolledValuesAreNoTick) {
  ChangesOnly robot;
  BeginToDrive(robot);
  robot.Tell({}, Status::kIdle);
  EXPECT_EQ(Asked(robot.run()).WhyNotText("drive"), "the tree was not ticked then");
}

TEST(WhyOfChanges, WithoutThatBeingSaidNoExceptionIsInvented) {
  ChangesOnly robot(false);
  BeginToDrive(robot);
  robot.Tell({{Told::kDark, Status::kFailure}});
  EXPECT_TRUE(Asked(robot.run()).Ask("drive").is_untold());
}

// Every built-in node with children: what it did not tick has a reason, what it ticked has steps.
TEST(WhyNot, HasAnAnswerForEveryNode) {
  for (const BuiltIn& node : BuiltIns()) {
    const std::string& id = node.manifest.id;
    if (node.children.max == 0 || id == "SubTree") continue;
    std::string xml = "<BehaviorTree ID='Main'><" + id + " name='top'";
    for (const PortDeclaration& port : node.manifest.ports) {
      if (!port.required) continue;
      const bool is_key = port.direction != PortDirection::kInput || !port.type;
      const bool is_script = port.type && std::string(port.type->name) == "script";
      std::string value = is_key ? "{" + port.name + "}" : is_script ? "true" : "1";
      if (port.name == "cases") value = "1;2;3";
      xml += " " + port.name + "='" + value + "'";
    }
    xml += ">";
    const std::uint32_t count = std::max(node.children.min, std::min(node.children.max, 4u));
    for (std::uint32_t k = 0; k < count; ++k) {
      xml += k % 2 == 0 ? "<AlwaysFailure/>" : "<AlwaysSuccess/>";
    }
    RecordedRun run(xml + "</" + id + "></BehaviorTree>");
    for (int tick = 0; tick < 4; ++tick) {
      run.Tick();
      Diagnostics diagnostics;
      const RecordedTree tree =
          CompileRecorded(run.keeper.run.trees()[0], std::make_shared<Registry>(), diagnostics);
      ASSERT_EQ(diagnostics.ToString(), "") << id;
      const TickView now = run.keeper.run.Before(static_cast<std::size_t>(tick));
      for (NodeIndex i{0}; i < tree.shape.size(); ++i) {
        const Why why = WhyOf(tree, now, nullptr, i);
        EXPECT_EQ(why.was_ticked, !why.why_not.has_value()) << id;
        EXPECT_EQ(why.status, run.executor.statuses()[i]) << id << " " << i;
        ASSERT_FALSE(why.steps.empty()) << id;
        EXPECT_EQ(why.steps.front().node, 0u) << id;
        if (why.why_not) {
          EXPECT_NE(SentenceOf(tree, *why.why_not), "") << id;
        }
      }
    }
  }
}

}  // namespace
}  // namespace coppice
