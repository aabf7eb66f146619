#include "editor/document/fixes.h"

#include <gtest/gtest.h>

#include "bt_core/engine/compile/check_project.h"
#include "bt_core/engine/compile/model_registry.h"
#include "bt_core/model/project.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = "a.xml";

// Checks a text with one problem as the editor does, and returns it with its first fix made.
std::string Fixed(const std::string& nodes) {
  const std::string text =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"A\">\n"
      "<BehaviorTree ID=\"A\">\n" +
      nodes +
      "\n</BehaviorTree>\n<TreeNodesModel>"
      R"(<Action ID="Say"><input_port name="text" type="std::string"/>)"
      "</Action></TreeNodesModel></root>";
  Diagnostics diagnostics;
  auto project = std::make_shared<const Project>(*Project::FromText(text, kFile, diagnostics));
  auto registry = std::make_shared<Registry>();
  coppice::AddModels(*project, *registry);
  CheckProject(project, registry, {}, diagnostics);
  const auto document = Document::FromText(text, kFile, diagnostics);
  for (const Diagnostic& problem : diagnostics.all()) {
    const std::vector<Fix> fixes = FixesFor(*document, problem);
    if (fixes.empty()) continue;
    const std::string after = Apply(fixes[0].edit, text);
    const std::size_t begin = after.find("\"A\">\n", after.find("<BehaviorTree")) + 5;
    return after.substr(begin, after.find("\n</BehaviorTree>") - begin);
  }
  return "no fix for " + diagnostics.ToString();
}

TEST(Fixes, PutTheNearestNodeInThePlaceOfAnUnknownOne) {
  EXPECT_EQ(Fixed(R"(<Sequense><Say text="a"/></Sequense>)"),
            R"(<Sequence><Say text="a"/></Sequence>)");
}

TEST(Fixes, RenameAPortThatNobodyKnows) {
  EXPECT_EQ(Fixed(R"(<Say texd="a"/>)"), R"(<Say text="a"/>)");
}

TEST(Fixes, GiveAPortThatIsMissing) {
  EXPECT_EQ(Fixed(R"(<Repeat><Say text="a"/></Repeat>)"),
            R"(<Repeat num_cycles=""><Say text="a"/></Repeat>)");
}

TEST(Fixes, OfAScriptReplaceItsOneWrongWord) {
  EXPECT_EQ(Fixed(R"(<Say text="a" _skipIf="n = 1 || true"/>)"),
            R"(<Say text="a" _skipIf="n == 1 || true"/>)");
  EXPECT_EQ(Fixed("<Script code='n := 1 + mim(2, 3)'/>"), "<Script code='n := 1 + min(2, 3)'/>");
}

TEST(Fixes, RemoveAPortThatNobodyKnowsAndThatIsNearToNone) {
  EXPECT_EQ(Fixed(R"(<Say text="a" colour="red"/>)"), R"(<Say text="a"/>)");
}

TEST(Fixes, OfTypesWithoutAModelAreCommands) {
  Diagnostics diagnostics;
  const auto document = Document::FromText("<root><A/></root>", kFile, diagnostics);
  const auto fixes = FixesFor(
      *document,
      {Severity::kWarning, {kFile, 1, 7}, "as it is worded", "", {ProblemKind::kNoModel, "A"}});
  ASSERT_EQ(fixes.size(), 2U);
  EXPECT_EQ(fixes[0].command, "file.models");
  EXPECT_EQ(fixes[1].command, "type.define");
}

TEST(Fixes, AreNotOfferedWhereNoNameIsNear) {
  EXPECT_EQ(Fixed(R"(<SubTree ID="Wander"/>)").substr(0, 6), "no fix");
}

TEST(Fixes, TheOffsetOfALineAndColumnStaysInTheText) {
  Diagnostics diagnostics;
  const auto document = Document::FromText("<a>\n<b/></a>", kFile, diagnostics);
  EXPECT_EQ(OffsetOf(*document, {kFile, 1, 1}), 0U);
  EXPECT_EQ(OffsetOf(*document, {kFile, 2, 2}), 5U);
  EXPECT_EQ(OffsetOf(*document, {kFile, 9, 9}), 12U);
}

}  // namespace
}  // namespace coppice::editor
