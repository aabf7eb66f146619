#include "editor/simulation/open_tree.h"

#include <gtest/gtest.h>

#include <fstream>

namespace coppice::editor {
namespace {

std::string InTemp(const std::string& name, const std::string& trees) {
  const std::string path = testing::TempDir() + name;
  std::ofstream(path) << R"(<root BTCPP_format="4">)" << trees << "</root>";
  return path;
}

TEST(OpenTree, TheTextInMemoryCountsAlsoOfAnIncludedFile) {
  InTemp("open_tree_in.xml", R"(<BehaviorTree ID="In"><A/></BehaviorTree>)");
  const std::string path =
      InTemp("open_tree.xml", R"(<include path="open_tree_in.xml"/>)"
                              R"(<BehaviorTree ID="Main"><SubTree ID="In"/></BehaviorTree>)");
  OpenProject files;
  Diagnostics diagnostics;
  ASSERT_TRUE(CompileOpenTree(files, path, "Main", nullptr, diagnostics)) << diagnostics.ToString();
  for (const auto& [name, file] : files.files()) {
    if (name.find("_in.xml") == std::string::npos) continue;
    files.SetText(name, "Type",
                  R"(<root BTCPP_format="4"><BehaviorTree ID="In"><B/></BehaviorTree></root>)");
    break;
  }
  const auto program = CompileOpenTree(files, path, "Main", nullptr, diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  EXPECT_EQ(program->Id(NodeIndex{1}), "B");
  EXPECT_EQ(CompileOpenTree(files, path, "In", nullptr, diagnostics)->nodes.size(), 1U);
}

TEST(OpenTree, OfAnotherOpenFileCounts) {
  OpenProject files;
  files.Create("pick.xml", R"(<root BTCPP_format="4"><BehaviorTree ID="Pick"><SubTree ID="Move"/>)"
                           "</BehaviorTree></root>");
  files.Create("move.xml",
               R"(<root BTCPP_format="4"><BehaviorTree ID="Move"><B/></BehaviorTree></root>)");
  Diagnostics diagnostics;
  const auto program = CompileOpenTree(files, "pick.xml", "", nullptr, diagnostics);
  ASSERT_TRUE(program) << diagnostics.ToString();
  EXPECT_EQ(program->Id(NodeIndex{1}), "B");
}

TEST(OpenTree, ErrorsAreSaid) {
  OpenProject files;
  files.Create("wrong.xml",
               R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Inverter/></BehaviorTree>)"
               "</root>");
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileOpenTree(files, "wrong.xml", "", nullptr, diagnostics));
  EXPECT_NE(diagnostics.ToString().find("wrong.xml:1:"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
