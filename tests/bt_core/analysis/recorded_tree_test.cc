#include "bt_core/analysis/recorded_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "tests/bt_core/analysis/recorded_run.h"

struct Room {
  std::string name;
};

template <>
struct coppice::ValueTraits<Room> {
  static constexpr const char* kName = "Room";
  static bool Parse(std::string_view text, Room& out) { return out.name = text, true; }
  static std::string Print(const Room& room) { return room.name; }
};

namespace coppice {
namespace {

class Visit final : public Condition {
 public:
  static constexpr const char* kDescription = "Is there a room?";
  Input<Room> room{this, "room", "where"};
  bool Check() override { return !room->name.empty(); }
};

using ::testing::HasSubstr;

constexpr char kTree[] =
    "<BehaviorTree ID='Main'><Sequence><SubTree ID='Sub' name='one' in='{k}'/>"
    "<SubTree ID='Sub' name='two' in='{j}'/></Sequence></BehaviorTree>"
    "<BehaviorTree ID='Sub'><ScriptCondition name='c' code='in == 1'/></BehaviorTree>";

RecordedTree Compiled(const TreeDescription& description, std::string& problems) {
  Diagnostics diagnostics;
  RecordedTree tree = CompileRecorded(description, std::make_shared<Registry>(), diagnostics);
  problems = diagnostics.ToString();
  return tree;
}

TEST(RecordedTree, IsTheProgramThatWasRecorded) {
  RecordedRun run(kTree);
  std::string problems;
  const RecordedTree tree = Compiled(run.keeper.run.trees()[0], problems);
  ASSERT_TRUE(tree.program) << problems;
  EXPECT_EQ(problems, "");
  for (NodeIndex i{0}; i < tree.shape.size(); ++i) {
    EXPECT_EQ(tree.program->Path(i), run.program->Path(i));
  }
  for (SlotIndex i{0}; i < tree.recorded_slots.size(); ++i) {
    if (tree.program->layout.slots[i].key.empty()) continue;
    EXPECT_EQ(run.program->layout.slots[tree.recorded_slots[i]].key,
              tree.program->layout.slots[i].key);
  }
}

TEST(RecordedTree, FindsNodesByTheEndOfTheirPath) {
  RecordedRun run(kTree);
  std::string problems;
  const RecordedTree tree = Compiled(run.keeper.run.trees()[0], problems);
  Diagnostics diagnostics;
  EXPECT_EQ(tree.Find("one/c", diagnostics), 2u);
  EXPECT_EQ(tree.Find("two", diagnostics), 3u);
  EXPECT_EQ(tree.Find("c", diagnostics), kNoNode);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("it may be one/c two/c"));
  EXPECT_EQ(tree.Find("ona/c", diagnostics), kNoNode);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr(R"(did you mean "one/c"?)"));
}

TEST(RecordedTree, HasNoProgramIfTheDocumentsAreOthers) {
  RecordedRun run(kTree);
  std::string problems;
  TreeDescription other = run.keeper.run.trees()[0];
  other.nodes[2].path = "elsewhere";
  EXPECT_FALSE(Compiled(other, problems).program);
  EXPECT_THAT(problems, HasSubstr("in the place of elsewhere"));
  other = run.keeper.run.trees()[0];
  other.documents[0].text = "<root><BehaviorTree ID='Main'><Sequence/></BehaviorTree></root>";
  EXPECT_FALSE(Compiled(other, problems).program);
  EXPECT_THAT(problems, HasSubstr("cannot be compiled"));
}

// The program is the last that knows the registry of the replay, which has the type.
TEST(RecordedTree, AKeyOfATypeThatOnlyTheRobotKnewEndsBeforeItsType) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Visit>("Visit");
  RecordedRun run(
      "<BehaviorTree ID='Main'><SubTree ID='Sub' to='3rd floor'/></BehaviorTree>"
      "<BehaviorTree ID='Sub'><Visit room='{to}'/></BehaviorTree>",
      registry);
  std::string problems;
  const RecordedTree tree = Compiled(run.keeper.run.trees()[0], problems);
  ASSERT_TRUE(tree.program) << problems;
  const auto& slots = tree.program->layout.slots;
  EXPECT_TRUE(std::any_of(slots.begin(), slots.end(), [](const SlotDefinition& slot) {
    return slot.initial.type() != nullptr && slot.initial.type()->name == std::string("Room");
  }));
}

}  // namespace
}  // namespace coppice
