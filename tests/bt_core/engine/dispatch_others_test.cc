// Every built-in node is ticked by a function of its own.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

// A value for a port that must be given.
std::string ValueFor(const PortDeclaration& port) {
  if (port.direction != PortDirection::kInput) return "{" + port.name + "}";
  if (!port.type) return "1";
  for (const std::string text : {"1", "true", "SUCCESS"}) {
    if (Value().Parse(*port.type, text)) return text;
  }
  return "1;2";
}

std::string Element(const Registry::Entry& entry) {
  const std::string& id = entry.manifest.id;
  std::string xml = "<" + id + " name=\"it\"";
  for (const PortDeclaration& port : entry.manifest.ports) {
    if (port.required) xml += " " + port.name + "=\"" + ValueFor(port) + "\"";
  }
  xml += ">";
  for (std::uint32_t i = 0; i < entry.children.min; ++i) xml += "<AlwaysSuccess/>";
  return xml + "</" + id + ">";
}

class EachBuiltIn : public ::testing::TestWithParam<std::string> {};

TEST_P(EachBuiltIn, HasATickThatReturnsAResultWithoutComplaint) {
  const Registry registry;
  Stage stage(Main(Element(*registry.Find(GetParam()))));
  const KeepingSink& sink = stage.Listen();
  EXPECT_NE(stage.executor->Tick(), Status::kIdle);
  for (const NodeMessage& message : sink.ticks[0].messages) ADD_FAILURE() << message.text;
}

std::vector<std::string> AllButSubTree() {
  std::vector<std::string> ids = Registry().Ids();
  ids.erase(std::find(ids.begin(), ids.end(), "SubTree"));
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Nodes, EachBuiltIn, ::testing::ValuesIn(AllButSubTree()),
                         [](const auto& info) { return info.param; });

// SKIPPED ends nothing: the elements stay taken until the parent resets the loop.
class LoopThatIsSkippedInTheEnd : public ::testing::Test {
 protected:
  std::vector<std::string> EventsOf(int ticks, const std::string& before,
                                    const std::string& behind) {
    LeafScript script;
    script.results["long"] = {Status::kRunning};
    Stage stage(Main(before + "<LoopInt queue=\"1;2\" if_empty=\"SKIPPED\"><Leaf name=\"a\"/>" +
                     "</LoopInt>" + behind),
                script);
    for (int i = 0; i < ticks; ++i) stage.executor->Tick();
    return stage.TakeEvents();
  }
  const std::vector<std::string> once_ = {"start a", "start a"};
};

TEST_F(LoopThatIsSkippedInTheEnd, RunsOnceAsTheRoot) { EXPECT_EQ(EventsOf(9, "", ""), once_); }

TEST_F(LoopThatIsSkippedInTheEnd, RunsOnceInKeepRunningUntilFailure) {
  EXPECT_EQ(EventsOf(9, "<KeepRunningUntilFailure>", "</KeepRunningUntilFailure>"), once_);
}

TEST_F(LoopThatIsSkippedInTheEnd, RunsOnceBesideALongChild) {
  const std::vector<std::string> events = {"start a", "start long", "start a", "tick long",
                                           "tick long"};
  for (const std::string node : {"Parallel", "ParallelAll"}) {
    EXPECT_EQ(EventsOf(3, "<" + node + ">", "<Leaf name=\"long\"/></" + node + ">"), events);
  }
}

TEST_F(LoopThatIsSkippedInTheEnd, BeginsAgainWhenItsParentResetsIt) {
  EXPECT_EQ(EventsOf(6, "<ForceSuccess><Sequence>", "<AlwaysFailure/></Sequence></ForceSuccess>"),
            (std::vector<std::string>{"start a", "start a", "start a", "start a"}));
}

}  // namespace
}  // namespace coppice
