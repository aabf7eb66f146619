// Which tree is compiled, and what is said of a project before.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::string Problems(const std::string& text, const std::string& tree = {}) {
  Diagnostics diagnostics;
  const auto program = CompileText(text, diagnostics, TestRegistry(), tree);
  EXPECT_EQ(program == nullptr, diagnostics.has_errors());
  return diagnostics.ToString();
}

TEST(Compile, TheMainTreeMustExist) {
  EXPECT_EQ(Problems("<root BTCPP_format=\"4\" main_tree_to_execute=\"Mian\">\n"
                     R"(<BehaviorTree ID="Main"><AlwaysSuccess/></BehaviorTree></root>)"),
            "t.xml:1:46: error: no tree \"Mian\" (did you mean \"Main\"?)\n");
  EXPECT_EQ(Problems(Main("<AlwaysSuccess/>"), "Other"), "t.xml:1:1: error: no tree \"Other\"\n");
}

TEST(Compile, NothingComesOfAProjectThatIsNotWhole) {
  EXPECT_EQ(Problems(Root("<BehaviorTree ID=\"Main\"><Inverter/></BehaviorTree>\n"
                          R"(<BehaviorTree ID="Two"><AlwaysSuccess/><AlwaysSuccess/>)"
                          "</BehaviorTree>")),
            "t.xml:3:1: error: tree \"Two\" has 2 root nodes, expected exactly 1\n"
            "t.xml:2:25: error: Inverter has 0 children, expected exactly 1\n");
}

TEST(Compile, CompileFileReportsAMissingFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileFile("/no/such.xml", TestRegistry(), diagnostics));
  EXPECT_EQ(diagnostics.ToString(),
            "/no/such.xml: error: cannot be read: No such file or directory\n");
}

}  // namespace
}  // namespace coppice
