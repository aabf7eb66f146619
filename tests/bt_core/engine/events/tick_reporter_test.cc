#include "bt_core/engine/events/tick_reporter.h"

#include <gtest/gtest.h>

#include "bt_core/data/value_bytes.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

// Writes events down, one word for each.
class Scribe : public TickSink {
 public:
  explicit Scribe(const Program& program) : program_(program) {}
  void OnTick(const TickEvents& events) override {
    EventReader reader(events.words);
    for (Event event; reader.Next(event);) lines.push_back(Line(event));
    whole.push_back(events.is_whole);
  }
  std::vector<std::string> lines;
  std::vector<bool> whole;

 private:
  std::string Line(const Event& event) const {
    switch (event.code) {
      case EventCode::kReset:
        return "reset " + program_.Name(event.node());
      case EventCode::kWrite:
        return (event.writer == kNoNode ? "?" : program_.Name(event.writer)) + " writes " +
               Entry(event);
      case EventCode::kDelivery:
        return "inbox writes " + Entry(event);
      case EventCode::kText:
        return program_.Name(event.node()) + ": " + std::string(event.bytes);
      default:
        return program_.Name(event.node()) + " " + ToString(event.status());
    }
  }
  std::string Entry(const Event& event) const {
    return program_.layout.slots[event.index].key + "=" + PrintValueBytes(event.bytes);
  }

  const Program& program_;
};

struct Reported : Stage {
  explicit Reported(const std::string& body, LeafScript given = {})
      : Stage(Main(body), std::move(given)), scribe(*program) {
    executor->AddSink(&scribe);
  }
  ~Reported() { executor->RemoveSink(&scribe); }
  std::vector<std::string> Tick() {
    executor->Tick();
    return std::exchange(scribe.lines, {});
  }
  Scribe scribe;
};
using Lines = std::vector<std::string>;

LeafScript Results(std::map<std::string, std::vector<Status>> results) {
  LeafScript script;
  script.results = std::move(results);
  return script;
}

TEST(Reporting, NamesEveryNodeThatWasTickedInTheOrderOfTheResults) {
  Reported tree(R"(<Sequence name="s"><Leaf name="a"/><Leaf name="b"/></Sequence>)",
                Results({{"b", {Status::kRunning}}}));
  const Lines expected{"a SUCCESS", "b RUNNING", "s RUNNING"};
  EXPECT_EQ(tree.Tick(), expected);
  EXPECT_EQ(tree.Tick(), (Lines{"b RUNNING", "s RUNNING"})) << "also what stays as it was";
}

TEST(Reporting, AWriteComesBeforeTheResultOfItsWriter) {
  Reported tree(R"(<Sequence name="s"><Tell name="t" text="hello" to="{k}"/>)"
                R"(<Script name="c" code="n:=1"/></Sequence>)");
  EXPECT_EQ(tree.Tick(),
            (Lines{"t writes k=hello", "t SUCCESS", "c writes n=1", "c SUCCESS", "s SUCCESS"}));
}

TEST(Reporting, WhatAHookWritesIsWrittenByItsNode) {
  Reported tree(R"(<Leaf name="a" _onSuccess="done:=true"/>)");
  EXPECT_EQ(tree.Tick(), (Lines{"a SUCCESS", "a writes done=true"}));
}

TEST(Reporting, ADeliveryComesBeforeTheTick) {
  Reported tree(R"(<Tell name="t" text="{in}" to="{out}"/>)");
  tree.executor->Writer<std::string>("in").Send("news");
  EXPECT_EQ(tree.Tick(), (Lines{"inbox writes in=news", "t writes out=news", "t SUCCESS"}));
}

TEST(Reporting, AHaltResetsWhatRanFromTheTopDown) {
  Reported tree(R"(<Sequence name="s"><Leaf name="a"/></Sequence>)",
                Results({{"a", {Status::kRunning}}}));
  tree.Tick();
  tree.executor->Halt();
  EXPECT_EQ(tree.scribe.lines, (Lines{"reset s", "reset a"}));
}

TEST(Reporting, AHaltOfASkippedLeafStandsBeforeWhatItsHookWrites) {
  Reported tree(
      R"(<Sequence name="s"><Leaf name="a" _onHalted="k := 1"/><Leaf name="b"/></Sequence>)",
      Results({{"a", {Status::kRunning, Status::kSkipped}}, {"b", {Status::kFailure}}}));
  tree.Tick();
  EXPECT_EQ(tree.Tick(),
            (Lines{"a SKIPPED", "b FAILURE", "reset a", "a writes k=1", "reset b", "s FAILURE"}));
}

TEST(Reporting, NothingIsLeftOverForASinkThatComesLater) {
  Stage stage(Main(R"(<Leaf name="a"/>)"));
  Scribe first(*stage.program);
  Scribe second(*stage.program);
  stage.executor->AddSink(&first);
  stage.executor->Tick();
  stage.executor->RemoveSink(&first);
  stage.executor->Tick();
  stage.executor->AddSink(&second);
  stage.executor->Tick();
  stage.executor->RemoveSink(&second);
  EXPECT_EQ(second.lines, Lines{"a SUCCESS"});
}

std::vector<std::string> KeysOf(const Stage& stage, NodeIndex node) {
  const WrittenSlots written = WrittenSlotsOf(*stage.program);
  std::vector<std::string> keys;
  for (std::uint32_t i = written.first[node]; i != written.first[node + 1]; ++i) {
    keys.push_back(stage.program->layout.slots[written.slots[i]].key);
  }
  return keys;
}
using Keys = std::vector<std::string>;

TEST(WrittenSlots, AreThoseOfOutputs) {
  const Stage stage(Main(R"(<Tell text="{a}" to="{b}"/>)"));
  EXPECT_EQ(KeysOf(stage, kRootNode), Keys{"b"});
}

TEST(WrittenSlots, AreThoseThatScriptsAssign) {
  const Stage stage(Main(R"(<Sequence _onSuccess="done:=x"><Script code="n:=1; m:=n"/>)"
                         "<AlwaysSuccess/></Sequence>"));
  EXPECT_EQ(KeysOf(stage, kRootNode), Keys{"done"});
  EXPECT_EQ(KeysOf(stage, NodeIndex{1}), (Keys{"n", "m"}));
  EXPECT_EQ(KeysOf(stage, NodeIndex{2}), Keys());
}

TEST(WrittenSlots, ThereIsARangeForEveryNode) {
  const Stage stage(Main("<Sequence><AlwaysSuccess/><AlwaysFailure/></Sequence>"));
  EXPECT_EQ(WrittenSlotsOf(*stage.program).first, std::vector<std::uint32_t>(4, 0));
}

}  // namespace
}  // namespace coppice
