// Which attributes become guards and hooks, and what is said of others that begin with an
// underscore. What guards do is in executor tests.
#include "bt_core/engine/compile/compiler_guards.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

struct GuardReaderTest : testing::Test {
  // Reads the attributes of one element that is node 5.
  bool Read(const std::string& attributes) {
    project = Project::FromText("<root BTCPP_format=\"4\"><BehaviorTree ID=\"M\">\n<Node " +
                                    attributes + "/></BehaviorTree></root>",
                                "t.xml", diagnostics);
    return reader.Read(Site(*project, 0, ElementIndex{2}, keys.AddScope(kMainScope, false)),
                       NodeIndex{5}, guards);
  }

  Diagnostics diagnostics;
  Problems problems{diagnostics};
  Layout layout;
  KeyTable keys{layout};
  SlotTypes types{layout, problems};
  ScriptTable scripts{keys, types, problems};
  GuardReader reader{scripts, problems};
  std::optional<Project> project;
  std::vector<GuardRecord> guards;
};

TEST_F(GuardReaderTest, ANodeWithoutGuardsHasNoRecord) {
  EXPECT_FALSE(Read(R"(name="x" port="1" _description="d" _collapsed="true" _uid="3")"));
  EXPECT_TRUE(guards.empty());
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(GuardReaderTest, EachGuardGetsAScriptInItsPlace) {
  EXPECT_TRUE(Read(R"(_onHalted="a" port="{x}" _failureIf="b" _while="c")"));
  ASSERT_EQ(guards.size(), 1U);
  EXPECT_EQ(guards[0].node, 5U);
  const auto of = [this](Guard guard) {
    return guards[0].scripts[static_cast<std::size_t>(guard)];
  };
  EXPECT_EQ(of(Guard::kOnHalted), 0U);
  EXPECT_EQ(of(Guard::kFailureIf), 1U);
  EXPECT_EQ(of(Guard::kWhile), 2U);
  EXPECT_EQ(of(Guard::kSuccessIf), kNoScript);
}

TEST_F(GuardReaderTest, AllGuardsAreKnown) {
  for (const std::string_view name : kGuardAttributes) {
    EXPECT_TRUE(Read(std::string(name) + R"(="x")")) << name;
  }
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(GuardReaderTest, AMisspeltGuardIsAnErrorWithTheNearestName) {
  EXPECT_FALSE(Read(R"(_skipif="a" _onSucess="b" _no_such_thing="c")"));
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:7: error: unknown attribute \"_skipif\" (did you mean \"_skipIf\"?)\n"
            "t.xml:2:19: error: unknown attribute \"_onSucess\" (did you mean \"_onSuccess\"?)\n"
            "t.xml:2:33: error: unknown attribute \"_no_such_thing\"\n");
}

TEST_F(GuardReaderTest, TheSharedBlackboardOfFormat3IsExplained) {
  EXPECT_FALSE(Read(R"(__shared_blackboard="true")"));
  EXPECT_EQ(diagnostics.ToString(), R"(t.xml:2:7: error: unknown attribute "__shared_blackboard" )"
                                    "(in format 4 it is _autoremap=\"true\")\n");
}

TEST_F(GuardReaderTest, AScriptCannotComeFromTheBlackboard) {
  EXPECT_TRUE(Read(R"(_skipIf="{condition}")"));
  EXPECT_NE(diagnostics.ToString().find(
                R"(t.xml:2:16: error: a script cannot come from the blackboard: "{condition}")"),
            std::string::npos)
      << diagnostics.ToString();
}

TEST_F(GuardReaderTest, AutoremapIsTrueOrFalse) {
  Read(R"(_autoremap="maybe")");
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:19: error: \"maybe\" is not a value for \"_autoremap\" (expected true or "
            "false)\n");
}

}  // namespace
}  // namespace coppice
