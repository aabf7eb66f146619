#include "editor/settings/project_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/temporary_folder.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ProjectSettings, AreTheSameAfterWritingAndReading) {
  ProjectSettings settings;
  settings.folder = "/home/me/robot";
  settings.style.ports = ShownPorts::kNone;
  settings.tiles.outline = false;
  settings.files = {"a.xml", "trees/b.xml"};
  settings.trees = {{"a.xml", "Main \"one\"", true, {"1.2 Sequence"}},
                    {"trees/b.xml", "B", false, {}}};
  Diagnostics diagnostics;
  const ProjectSettings read = ReadProject(WriteProject(settings), "p.json", diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
  EXPECT_EQ(WriteProject(read), WriteProject(settings));
  EXPECT_EQ(read.folder, "/home/me/robot");
  EXPECT_EQ(read.style.ports, ShownPorts::kNone);
  EXPECT_FALSE(read.tiles.outline);
  EXPECT_THAT(read.files, ElementsAre("a.xml", "trees/b.xml"));
  ASSERT_EQ(read.trees.size(), 2U);
  EXPECT_TRUE(read.trees[0].has_tab);
  EXPECT_THAT(read.trees[0].closed, ElementsAre("1.2 Sequence"));
}

TEST(ProjectSettings, APathThatLeadsOutOfTheProjectIsSaidAndLeftOut) {
  Diagnostics diagnostics;
  const ProjectSettings read = ReadProject(
      R"({"folder": "/p", "files": ["/etc/passwd", "../x.xml", "a/../../x.xml", "", "in.xml"],)"
      R"( "trees": [{"file": "/dev/zero", "tree": "T"}, {"file": "in.xml", "tree": "T"}]})",
      "p.json", diagnostics);
  EXPECT_THAT(read.files, ElementsAre("in.xml"));
  EXPECT_EQ(read.trees.size(), 1U);
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"/etc/passwd\" is not a file of the project"));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("\"/dev/zero\" is not a file of the project"));
}

TEST(ProjectSettings, OfNonsenseAreThoseOfANewProject) {
  for (const char* text :
       {"", "[]", "{", "3", R"({"files": 3, "trees": "x"})", R"({"trees": [1, {}, []]})"}) {
    Diagnostics diagnostics;
    EXPECT_EQ(WriteProject(ReadProject(text, "p.json", diagnostics)), WriteProject({})) << text;
  }
}

TEST(ProjectSettings, OfAProjectWithTooManyFilesHaveTheFirst) {
  ProjectSettings settings;
  for (int i = 0; i < 10000; ++i) settings.files.push_back(std::to_string(i) + ".xml");
  Diagnostics diagnostics;
  const ProjectSettings read = ReadProject(WriteProject(settings), "p.json", diagnostics);
  EXPECT_LE(read.files.size(), 100U);
  EXPECT_EQ(read.files.front(), "0.xml");
}

TEST(PathInProject, IsEmptyForAFileElsewhere) {
  EXPECT_EQ(PathInProject("/a/robot", "/a/robot/trees/x.xml"), "trees/x.xml");
  EXPECT_EQ(PathInProject("/a/robot", "/a/robot2/x.xml"), "");
  EXPECT_EQ(PathInProject("/a/robot", "/a/robot/../x.xml"), "");
}

}  // namespace
}  // namespace coppice::editor
