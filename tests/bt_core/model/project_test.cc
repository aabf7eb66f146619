#include "bt_core/model/project.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice {
namespace {

namespace fs = std::filesystem;

// A folder of files that is gone after the test.
class ProjectTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("coppice_project_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  std::optional<Project> Load(const std::string& path, const PackageFinder& finder = {}) {
    return Project::FromFile(path, diagnostics_, finder);
  }

  fs::path folder_;
  Diagnostics diagnostics_;
};

std::string Root(const std::string& body, const std::string& attributes = "") {
  return "<root BTCPP_format=\"4\"" + attributes + ">\n" + body + "\n</root>";
}
std::string Tree(const std::string& id) {
  return "<BehaviorTree ID=\"" + id + "\"><AlwaysSuccess/></BehaviorTree>";
}

std::string Problems(const std::string& text) {
  Diagnostics diagnostics;
  Project::FromText(text, "t.xml", diagnostics);
  return diagnostics.ToString();
}

std::string MainTree(const std::string& text) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(text, "t.xml", diagnostics);
  return project ? project->main_tree() : "no project: " + diagnostics.ToString();
}

TEST(Project, FindsItsTrees) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(Root(Tree("A") + Tree("B")), "t.xml", diagnostics);
  ASSERT_TRUE(project);
  EXPECT_EQ(project->trees().size(), 2U);
  ASSERT_NE(project->Find("B"), nullptr);
  EXPECT_EQ(project->Find("C"), nullptr);
  const TreeDefinition& b = *project->Find("B");
  const Document& document = project->documents()[b.document];
  EXPECT_EQ(document.AttributeValue(document.element(b.element), "ID"), "B");
}

TEST(Project, TheMainTreeIsTheOneThatIsNamed) {
  EXPECT_EQ(MainTree(Root(Tree("A") + Tree("B"), " main_tree_to_execute=\"B\"")), "B");
}

TEST_F(ProjectTest, SeveralFilesAreOneProject) {
  const std::string a = Write("a.xml", Root("<include path=\"c.xml\"/>" + Tree("A")));
  const std::string b = Write("b.xml", Root(Tree("B"), " main_tree_to_execute=\"C\""));
  const std::string c = Write("c.xml", Root(Tree("C"), " main_tree_to_execute=\"A\""));
  const auto project = Project::FromFiles({a, b, c}, diagnostics_);
  ASSERT_TRUE(project) << diagnostics_.ToString();
  EXPECT_EQ(project->documents().size(), 3U);
  for (const char* id : {"A", "B", "C"}) EXPECT_NE(project->Find(id), nullptr) << id;
  EXPECT_EQ(project->main_tree(), "C") << "included files do not say which tree is the main one";
}

TEST_F(ProjectTest, ATreeThatTwoFilesDefineIsAnError) {
  const std::string a = Write("a.xml", Root(Tree("A")));
  const std::string b = Write("b.xml", Root(Tree("A") + "\n" + Tree("B")));
  const auto project = Project::FromFiles({a, b}, diagnostics_);
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->has_errors());
  EXPECT_EQ(diagnostics_.ToString(),
            b + ":2:1: error: tree \"A\" is defined twice (first defined at " + a + ":2)\n");
  EXPECT_EQ(project->Find("A")->document, 0U) << "the first one counts";
  EXPECT_NE(project->Find("B"), nullptr);
}

TEST_F(ProjectTest, AFileThatCannotBeReadDoesNotHideTheOthers) {
  const auto project = Project::FromFiles(
      {Path("no.xml"), Write("bad.xml", "<root>"), Write("a.xml", Root(Tree("A")))}, diagnostics_);
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->has_errors());
  EXPECT_NE(project->Find("A"), nullptr);
  EXPECT_EQ(diagnostics_.all().size(), 2U) << diagnostics_.ToString();
}

TEST_F(ProjectTest, WithoutAnyReadableFileThereIsNoProject) {
  EXPECT_FALSE(Load(Path("no.xml")));
  EXPECT_TRUE(diagnostics_.has_errors());
}

TEST(Project, EarlierErrorsInTheListAreNotItsOwn) {
  Diagnostics diagnostics;
  diagnostics.Error({}, "of something else");
  EXPECT_FALSE(Project::FromText(Root(Tree("A")), "t.xml", diagnostics)->has_errors());
}

TEST(Project, ATreeWithTwoRootNodesIsThereForTheChecksThatFollow) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(Root("<BehaviorTree ID=\"A\"><X/><Y/></BehaviorTree>"),
                                         "t.xml", diagnostics);
  EXPECT_TRUE(project->has_errors());
  EXPECT_NE(project->Find("A"), nullptr);
}

TEST(Project, KnowsTheModelsOfItsFiles) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(
      Root("<TreeNodesModel><Action ID=\"A\"/><SubTree ID=\"A\"><input_port name=\"x\"/></SubTree>"
           "</TreeNodesModel>"),
      "t.xml", diagnostics);
  EXPECT_EQ(project->models().count("A"), 1U);
  EXPECT_TRUE(project->models().find("A")->second.ports.empty());
  ASSERT_NE(project->SubTreeModel("A"), nullptr);
  EXPECT_NE(project->SubTreeModel("A")->FindPort("x"), nullptr);
  EXPECT_EQ(project->SubTreeModel("B"), nullptr);
}

TEST(Project, ModelsThatContradictEachOtherAreAWarning) {
  const std::string once = "<Action ID=\"A\"><input_port name=\"x\">words</input_port></Action>\n";
  const std::string same = "<Action ID=\"A\"><input_port name=\"x\"/></Action>\n";
  const std::string other = "<Action ID=\"A\"><output_port name=\"x\"/></Action>\n";
  EXPECT_EQ(Problems(Root("<TreeNodesModel>\n" + once + same + other + "</TreeNodesModel>")),
            "t.xml:5:1: warning: another model of \"A\" with other ports is ignored "
            "(the first one is at t.xml:3)\n");
}

TEST(Project, TheOnlyTreeIsTheMainTree) { EXPECT_EQ(MainTree(Root(Tree("A"))), "A"); }

TEST(Project, SeveralTreesWithoutANameHaveNoMainTree) {
  EXPECT_EQ(MainTree(Root(Tree("A") + Tree("B"))), "");
}

TEST(Project, WrongRootIsAnError) {
  EXPECT_EQ(Problems("<Root/>"),
            "t.xml:1:1: error: root element is <Root> (expected <root BTCPP_format=\"4\">)\n");
}

TEST(Project, MissingFormatIsAWarning) {
  EXPECT_EQ(Problems("<root>" + Tree("A") + "</root>"),
            "t.xml:1:1: warning: no BTCPP_format; read as format 4\n");
}

TEST(Project, Format3IsReadWithOneWarning) {
  Diagnostics diagnostics;
  const auto project = Project::FromText(
      "<root>\n <BehaviorTree ID=\"A\">\n  <SequenceStar>\n   <SubTree ID=\"B\" x=\"k\"/><N/>\n"
      "  </SequenceStar>\n </BehaviorTree>\n</root>",
      "t.xml", diagnostics);
  ASSERT_TRUE(project && !project->has_errors());
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:1:1: warning: format 3 is read as format 4 "
            "(\"coppice upgrade -i t.xml\" makes it format 4)\n");
  const Document& document = project->documents()[0];
  EXPECT_EQ(document.element(ElementIndex{2}).tag, "SequenceWithMemory");
  EXPECT_EQ(document.AttributeValue(document.element(ElementIndex{3}), "x"), "{k}");
  const SourceLocation where = document.Location(document.element(ElementIndex{4}).offset);
  EXPECT_EQ(where.line, 4U);
  EXPECT_EQ(where.column, 27U) << "the place in the user's own file";
}

TEST(Project, UnknownFormatIsAnError) {
  EXPECT_EQ(Problems("<root BTCPP_format=\"9\"/>"),
            "t.xml:1:21: error: BTCPP_format=\"9\" is not known (expected BTCPP_format=\"4\")\n");
}

TEST(Project, ReportsAllProblemsAtOnce) {
  EXPECT_EQ(Problems(Root("<BehaviourTree/>\n<BehaviorTree/>\n<BehaviorTree ID=\"E\"/>\n" +
                          Tree("A") + "\n  " + Tree("A"))),
            "t.xml:2:1: error: unexpected <BehaviourTree> below <root> "
            "(did you mean \"BehaviorTree\"?)\n"
            "t.xml:3:1: error: <BehaviorTree> without ID (only a file's sole tree needs none)\n"
            "t.xml:4:1: error: tree \"E\" has 0 root nodes, expected exactly 1\n"
            "t.xml:6:3: error: tree \"A\" is defined twice (first defined at t.xml:5)\n");
}

TEST(Project, TheSoleTreeNeedsNoId) {
  Diagnostics diagnostics;
  const auto project =
      Project::FromText(Root("<BehaviorTree><AlwaysSuccess/></BehaviorTree>\n<TreeNodesModel/>"),
                        "t.xml", diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_EQ(project->main_tree(), "BehaviorTree_0");
}

TEST(Project, ModelsAreNoTrees) {
  EXPECT_EQ(Problems(Root("<TreeNodesModel><Action ID=\"X\"/></TreeNodesModel>" + Tree("A"))), "");
}

TEST_F(ProjectTest, IncludesAreRelativeToTheFileThatIncludes) {
  Write("parts/deep/c.xml", Root(Tree("C")));
  Write("parts/b.xml", Root("<include path=\"deep/c.xml\"/>" + Tree("B")));
  const auto project = Load(Write("a.xml", Root("<include path=\"parts/b.xml\"/>" + Tree("A"))));
  ASSERT_TRUE(project) << diagnostics_.ToString();
  EXPECT_NE(project->Find("B"), nullptr);
  EXPECT_NE(project->Find("C"), nullptr);
  EXPECT_EQ(project->main_tree(), "A") << "trees of included files do not count";
}

TEST_F(ProjectTest, IncludesEndAtADepthWithAnError) {
  for (int i = 0; i < 150; ++i) {
    Write(std::to_string(i) + ".xml",
          Root("<include path=\"" + std::to_string(i + 1) + ".xml\"/>"));
  }
  const auto project = Load(Path("0.xml"));
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->has_errors());
  EXPECT_NE(diagnostics_.ToString().find("100.xml:2:1: error: files include each other more than"),
            std::string::npos)
      << diagnostics_.ToString();
}

TEST_F(ProjectTest, FilesMayIncludeEachOther) {
  Write("b.xml", Root("<include path=\"./a.xml\"/><include path=\"b.xml\"/>" + Tree("B")));
  const auto project = Load(Write("a.xml", Root("<include path=\"b.xml\"/>" + Tree("A"))));
  ASSERT_TRUE(project) << diagnostics_.ToString();
  EXPECT_EQ(project->documents().size(), 2U);
}

TEST_F(ProjectTest, AFileIsReadOnceByWhateverName) {
  Write("b.xml", Root(Tree("B")));
  fs::create_symlink(folder_ / "b.xml", folder_ / "link.xml");
  const auto project = Load(
      Write("a.xml", Root("<include path=\"b.xml\"/><include path=\"link.xml\"/>" + Tree("A"))));
  ASSERT_TRUE(project) << diagnostics_.ToString();
  EXPECT_EQ(project->documents().size(), 2U);
}

TEST_F(ProjectTest, MissingIncludesAreReportedWithTheirPlace) {
  const std::string a = Write("a.xml", Root("<include path=\"no.xml\"/>\n <include/>" + Tree("A")));
  const auto project = Load(a);
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->has_errors());
  EXPECT_NE(project->Find("A"), nullptr) << "a broken include does not hide the rest";
  EXPECT_EQ(diagnostics_.ToString(), a + ":2:16: error: included file " + Path("no.xml") +
                                         " does not exist\n" + a +
                                         ":3:2: error: <include> without path\n");
}

TEST_F(ProjectTest, ProblemsOfAnIncludedFileNameThatFile) {
  const std::string b = Write("b.xml", "<root BTCPP_format=\"4\">\n<Include/></root>");
  const auto project = Load(Write("a.xml", Root("<include path=\"b.xml\"/>" + Tree("A"))));
  EXPECT_TRUE(project && project->has_errors());
  EXPECT_EQ(diagnostics_.ToString(),
            b + ":2:1: error: unexpected <Include> below <root> (did you mean \"include\"?)\n");
}

TEST_F(ProjectTest, PackagesAreAskedFor) {
  Write("pkg/trees/b.xml", Root(Tree("B")));
  const std::string a =
      Write("a.xml", Root("<include ros_pkg=\"sobi\" path=\"trees/b.xml\"/>" + Tree("A")));
  const auto project = Load(a, [this](const std::string& package) {
    return package == "sobi" ? Path("pkg") : std::string();
  });
  ASSERT_TRUE(project) << diagnostics_.ToString();
  EXPECT_NE(project->Find("B"), nullptr);
}

TEST_F(ProjectTest, LooksForAPackageOnceAndForFewThatThereAreNot) {
  std::string includes;
  for (int i = 0; i < 100; ++i) {
    includes += "<include ros_pkg=\"sobi\" path=\"b.xml\"/><include ros_pkg=\"no" +
                std::to_string(i) + "\" path=\"b.xml\"/>";
  }
  Write("b.xml", Root(Tree("B")));
  int asked = 0;
  Load(Write("a.xml", Root(includes)), [&](const std::string& package) {
    ++asked;
    return package == "sobi" ? folder_.string() : "";
  });
  EXPECT_EQ(asked, 1 + 16);
  EXPECT_EQ(diagnostics_.all().size(), 100u);
}

TEST_F(ProjectTest, AnUnknownPackageIsAnError) {
  const std::string a = Write("a.xml", Root("<include ros_pkg=\"sobi\" path=\"b.xml\"/>"));
  EXPECT_TRUE(Load(a)->has_errors());
  EXPECT_NE(diagnostics_.ToString().find("ROS package \"sobi\" was not found"), std::string::npos);
}

TEST(Project, WhatOtherProgramsKeepBelowRootIsIgnoredWithAWarning) {
  EXPECT_EQ(Problems(Root(Tree("A") + "\n<Environment><Pose/></Environment>")),
            "t.xml:3:1: warning: <Environment> below <root> is ignored\n");
}

TEST_F(ProjectTest, InFormat3ATreeOfAnotherFileIsANodeTypeToo) {
  Write("b.xml", "<root BTCPP_format=\"3\">" + Tree("B") + "</root>");
  const std::string a = Write("a.xml",
                              "<root BTCPP_format=\"3\"><include path=\"b.xml\"/>\n"
                              "<BehaviorTree ID=\"A\">\n<B k=\"goal\"/></BehaviorTree></root>");
  const auto project = Load(a);
  ASSERT_TRUE(project);
  const Document& document = project->documents()[0];
  const ElementIndex used = document.element(project->Find("A")->element).first_child;
  EXPECT_EQ(document.element(used).tag, "SubTree");
  EXPECT_EQ(document.AttributeValue(document.element(used), "ID"), "B");
  EXPECT_EQ(document.AttributeValue(document.element(used), "k"), "{goal}");
  const SourceLocation where = document.Location(document.element(used).offset);
  EXPECT_EQ(where.line, 3);  // in the user's own text
  EXPECT_EQ(where.column, 1);
}

TEST(Project, KnowsWhichDocumentsWereOfFormat3) {
  Diagnostics diagnostics;
  const auto old = Project::FromText("<root>" + Tree("A") + "</root>", "t.xml", diagnostics);
  EXPECT_TRUE(old->WasFormat3(0));
  EXPECT_FALSE(Project::FromText(Root(Tree("A")), "t.xml", diagnostics)->WasFormat3(0));
}

TEST(Project, WhatFormat3SaysOtherwiseIsSaidToBeFormat3) {
  const std::string text =
      "<root>\n<BehaviorTree ID=\"A\"><SubTree ID=\"B\" k=\"0.5\"/>"
      "</BehaviorTree>" +
      Tree("B") + "</root>";
  const std::string problems = Problems(text);
  EXPECT_NE(problems.find("in format 3, the attributes"), std::string::npos) << problems;
  EXPECT_NE(problems.find("format 3 is read as format 4"), std::string::npos) << problems;
}

}  // namespace
}  // namespace coppice
