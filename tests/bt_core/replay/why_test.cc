#include "bt_core/replay/why.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bt_core/replay/why_text.h"
#include "tests/bt_core/replay/recorded_run.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;

// A run that is asked about its last tick.
class Asked {
 public:
  explicit Asked(const Recording& run) : run_(run) {
    Diagnostics diagnostics;
    tree_ = CompileRecorded(run.trees().back(), std::make_shared<Registry>(), diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
  }

  Why Ask(const std::string& path) {
    Diagnostics diagnostics;
    const NodeIndex node = tree_.Find(path, diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
    std::size_t last = run_.ticks().size() - 1;
    const TickView now = run_.Before(last);
    std::optional<TickView> before;
    if (const auto earlier = run_.TickBefore(last)) before = run_.Before(*earlier);
    return WhyOf(tree_, now, before ? &*before : nullptr, node);
  }

  std::string Print(const std::string& path) { return PrintWhy(tree_, Ask(path), run_.start()); }
  std::string WhyNotText(const std::string& path) {
    const Why why = Ask(path);
    return why.why_not ? SentenceOf(tree_, *why.why_not) : "it was ticked";
  }
  std::string Json(const std::string& path) { return WhyToJson(tree_, Ask(path), run_.start()); }
  const RecordedTree& tree() const { return tree_; }

 private:
  const Recording& run_;
  RecordedTree tree_;
};

class Lamp final : public Condition {
 public:
  static constexpr const char* kDescription = "Is it dark?";
  Input<double> lux{this, "lux", "brightness"};
  bool Check() override { return *lux < 10; }
};

std::shared_ptr<Registry> Lamps() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Lamp>("Lamp");
  return registry;
}

constexpr char kPatrol[] =
    "<BehaviorTree ID='Main'><Fallback name='root'><Sequence name='safety'>"
    "<ScriptCondition name='battery_low' code='battery &lt; 20'/><AlwaysSuccess name='dock'/>"
    "</Sequence><Sequence name='work'><Lamp name='dark' lux='{lux}'/><Sleep name='drive' "
    "msec='1000'/></Sequence></Fallback></BehaviorTree>";

TEST(Why, TellsTheWalkAndWhatWasRead) {
  RecordedRun run(kPatrol, Lamps());
  run.executor.Writer<double>("battery").Send(50);
  run.executor.Writer<double>("lux").Send(3);
  run.Tick();
  Asked asked(run.keeper.run);
  const Why why = asked.Ask("drive");
  EXPECT_TRUE(why.was_ticked);
  EXPECT_EQ(why.status, Status::kRunning);
  ASSERT_EQ(why.steps.size(), 6u);
  EXPECT_EQ(asked.tree().NameOf(why.steps[0].node), "root");
  EXPECT_EQ(asked.tree().NameOf(why.steps[2].node), "battery_low");
  EXPECT_EQ(why.steps[2].cause, WhyCause::kScript);
  EXPECT_EQ(why.steps[2].script->answer, false);
  EXPECT_TRUE(why.steps[5].is_asked);
  const std::string text = asked.Print("drive");
  EXPECT_THAT(text,
              HasSubstr("battery_low  FAILURE  code=\"battery < 20\" is false: battery = 50"));
  EXPECT_THAT(text, HasSubstr("dark  SUCCESS  lux = 3"));
  EXPECT_THAT(text, HasSubstr("safety  FAILURE  because of battery_low"));
}

TEST(Why, NamesWhatChangedSinceTheTickBefore) {
  RecordedRun run(kPatrol, Lamps());
  const Sender<double> battery = run.executor.Writer<double>("battery");
  battery.Send(50);
  run.executor.Writer<double>("lux").Send(30);
  run.Tick();
  battery.Send(12);
  run.Tick();
  Asked asked(run.keeper.run);
  const Why why = asked.Ask("root");
  ASSERT_TRUE(why.change);
  EXPECT_EQ(asked.tree().NameOf(why.change->step.node), "battery_low");
  EXPECT_THAT(asked.Print("root"),
              HasSubstr("first change: battery_low is SUCCESS, was FAILURE; code=\"battery < 20\" "
                        "is true: battery = 12 (was 50)"));
  EXPECT_EQ(asked.WhyNotText("drive"), "root did not come to work: safety before it is SUCCESS");
}

TEST(Why, SaysThatNothingChanged) {
  RecordedRun run("<BehaviorTree ID='Main'><AlwaysFailure name='a'/></BehaviorTree>");
  run.Tick();
  run.Tick();
  EXPECT_FALSE(Asked(run.keeper.run).Ask("a").change);
}

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
  EXPECT_THAT(asked.Print("a"), HasSubstr("s  SKIPPED  not ticked, _skipIf=\"mode == 2\" is true: "
                                          "mode = 2"));
}

TEST(WhyNot, KnowsWhatIsDoneAlready) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><Sequence name='s'><AlwaysSuccess name='a'/><Sleep name='b' "
      "msec='500'/></Sequence></BehaviorTree>");
  run.Tick();
  run.Tick();
  EXPECT_EQ(Asked(run.keeper.run).WhyNotText("a"),
            "s did not tick a again, which is SUCCESS already");
}

TEST(WhyNot, KnowsWhichChildChoosesTheOthers) {
  RecordedRun run(
      "<BehaviorTree ID='Main'><IfThenElse name='if'><AlwaysFailure name='c'/>"
      "<AlwaysSuccess name='then'/><AlwaysSuccess name='else'/></IfThenElse></BehaviorTree>");
  run.Tick();
  Asked asked(run.keeper.run);
  EXPECT_EQ(asked.WhyNotText("then"), "if did not come to then: c before it is FAILURE");
  EXPECT_EQ(asked.WhyNotText("else"), "it was ticked");
}

TEST(WhyNot, KnowsTicksThatWereNone) {
  RecordedRun run("<BehaviorTree ID='Main'><Sleep name='a' msec='500'/></BehaviorTree>");
  run.Tick();
  run.executor.Halt();
  EXPECT_EQ(Asked(run.keeper.run).WhyNotText("a"), "this was no tick of the tree");
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
  EXPECT_EQ(asked.WhyNotText("a"), "the tick was ended by an exception of c");
  EXPECT_THAT(asked.Print("a"), HasSubstr("and was not ticked\nwhy not: the tick was ended"));
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
    told_.OnTick({++tick_, Time(0), Duration(0), root, true, words.words()});
  }
  const Recording& run() const { return told_; }

  static constexpr NodeIndex kRoot = 0, kSafety = 1, kLow = 2, kWork = 4, kDark = 5, kDrive = 6;

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
    EXPECT_THAT(text, HasSubstr(std::string("only changes of status are told, and none of ") +
                                node + ": it may have been ticked"));
    EXPECT_THAT(text, Not(HasSubstr("exception"))) << node;
    EXPECT_THAT(text, Not(HasSubstr("not ticked"))) << node;
    EXPECT_THAT(text, HasSubstr("first change: dark is FAILURE, was SUCCESS")) << text;
  }
  EXPECT_THAT(asked.Json("drive"), HasSubstr("\"cause\":\"not_told\""));
  EXPECT_THAT(asked.Json("drive"), Not(HasSubstr("\"ticked\"")));
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
            "work did not come to drive: dark before it is FAILURE");
}

TEST(WhyOfChanges, PolledValuesAreNoTick) {
  ChangesOnly robot;
  BeginToDrive(robot);
  robot.Tell({}, Status::kIdle);
  EXPECT_EQ(Asked(robot.run()).WhyNotText("drive"), "this was no tick of the tree");
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
      for (NodeIndex i = 0; i < tree.shape.size(); ++i) {
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
