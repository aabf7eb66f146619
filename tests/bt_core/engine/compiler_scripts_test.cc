#include "bt_core/engine/compiler_scripts.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

struct ScriptTableTest : testing::Test {
  Diagnostics diagnostics;
  const Project project = *Project::FromText(
      "<root BTCPP_format=\"4\"><BehaviorTree ID=\"M\">\n<Script code=\"a b\" key=\"{k}\"/>"
      "</BehaviorTree></root>",
      "t.xml", diagnostics);
  Problems problems{diagnostics};
  Layout layout;
  KeyTable keys{layout, problems};
  ScriptTable scripts{keys, problems};

  Site TheNode() { return Site(project, 0, 2, keys.AddScope(0, false)); }
};

TEST_F(ScriptTableTest, ScriptsAreNumberedInTheOrderOfAdding) {
  const Site site = TheNode();
  EXPECT_EQ(scripts.Add(site, site.begin()[0]), 0U);
  EXPECT_EQ(scripts.AddDefault(site, "x"), 1U);
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST_F(ScriptTableTest, AKeyInBracesIsNoScript) {
  const Site site = TheNode();
  EXPECT_EQ(scripts.Add(site, site.begin()[1]), kNoScript);
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:2:25: error: a script cannot come from the blackboard: \"{k}\" (it is compiled "
            "when the tree is loaded; write the script itself, in which a key stands without "
            "braces)\n");
}

}  // namespace
}  // namespace coppice
