#include "editor/export/export_verb.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"
#include "tests/editor/export/painted.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

class ExportVerbTest : public testing::Test {
 protected:
  // What the verb prints to standard error is in errors_.
  int Run(std::vector<std::string> arguments) {
    testing::internal::CaptureStderr();
    const int code = RunExport(arguments);
    errors_ = testing::internal::GetCapturedStderr();
    return code;
  }
  std::string Picture() const { return ReadFile(picture_); }

  TemporaryFile file_{"small.xml", kSmallFile};
  const std::string picture_ = file_.folder() + "/tree.svg";
  std::string errors_;
};

TEST_F(ExportVerbTest, PaintsTheMainTreeWithItsSubTrees) {
  ASSERT_EQ(Run({file_.path(), "-o", picture_}), 0) << errors_;
  EXPECT_EQ(CountOf(Picture(), ">MainTree</text>"), 1U);
  EXPECT_EQ(CountOf(Picture(), ">Step</text>"), 1U);
}

TEST_F(ExportVerbTest, PaintsTheTreeThatIsAskedFor) {
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--tree", "Walk"}), 0) << errors_;
  EXPECT_EQ(CountOf(Picture(), ">round</text>"), 0U);
  EXPECT_EQ(CountOf(Picture(), ">Step</text>"), 1U);
}

TEST_F(ExportVerbTest, PaintsAllTreesEachOnce) {
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--all"}), 0) << errors_;
  EXPECT_EQ(CountOf(Picture(), ">round</text>"), 1U);
  EXPECT_EQ(CountOf(Picture(), ">Step</text>"), 1U);
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--closed"}), 0) << errors_;
  EXPECT_EQ(CountOf(Picture(), ">Step</text>"), 0U);
}

TEST_F(ExportVerbTest, KnowsTheNodesOfWellKnownPrograms) {
  const auto picture = [this](const std::string& more) {
    file_.Write("<root BTCPP_format='4'><BehaviorTree ID='T'><Sequence><GoalUpdated/>" + more +
                "</Sequence></BehaviorTree></root>");
    EXPECT_EQ(Run({file_.path(), "-o", picture_}), 0) << errors_;
    return Picture();
  };
  const std::string unknown = "#4a4a52";  // the colour of what nobody knows
  EXPECT_GT(CountOf(picture("<Strange/>"), unknown), 0U);
  EXPECT_EQ(CountOf(picture("<FollowPath path='{p}'/>"), unknown), 0U);
}

TEST_F(ExportVerbTest, KnowsTheModelsOfOtherFiles) {
  const TemporaryFile models("models.xml",
                             "<root BTCPP_format='4'><TreeNodesModel><Condition ID='Step'/>"
                             "</TreeNodesModel></root>");
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--tree", "Walk"}), 0);
  const std::string without = Picture();
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--tree", "Walk", "--models", models.path()}), 0);
  EXPECT_NE(Picture(), without);
}

TEST_F(ExportVerbTest, PaintsSidewaysAndInOtherColours) {
  ASSERT_EQ(Run({file_.path(), "-o", picture_}), 0);
  const std::string down = Picture();
  for (const char* option : {"--across", "--compact", "--layered"}) {
    ASSERT_EQ(Run({file_.path(), "-o", picture_, option}), 0);
    EXPECT_NE(Picture(), down) << option;
  }
  ASSERT_EQ(Run({file_.path(), "-o", picture_, "--palette", "dark"}), 0);
  EXPECT_NE(Picture(), down);
}

TEST_F(ExportVerbTest, RefusesWhatItDoesNotUnderstand) {
  EXPECT_EQ(Run({}), 2);
  EXPECT_EQ(Run({file_.path()}), 2);
  EXPECT_NE(errors_.find(".svg"), std::string::npos);
  EXPECT_EQ(Run({file_.path(), "-o", "t.gif"}), 2);
  EXPECT_EQ(Run({file_.path(), "-o", picture_, "--palette", "pink"}), 2);
  EXPECT_NE(errors_.find("colourblind"), std::string::npos);
  for (const char* scale : {"", "x", "0", "nan", "5"}) {
    EXPECT_EQ(Run({file_.path(), "-o", picture_, "--scale", scale}), 2) << scale;
  }
  EXPECT_EQ(Run({file_.path(), "-o", picture_, "--tree", "Wolk"}), 2);
  EXPECT_NE(errors_.find(R"(did you mean "Walk")"), std::string::npos) << errors_;
}

TEST_F(ExportVerbTest, SaysWhatIsWrongWithAFileAndPaintsWhatCanBeRead) {
  file_.Write("<root><Behavior");
  EXPECT_EQ(Run({file_.path(), "-o", picture_}), 1);
  EXPECT_NE(errors_.find("small.xml:1"), std::string::npos) << errors_;
  EXPECT_FALSE(std::filesystem::exists(picture_));
  file_.Write(
      "<root BTCPP_format='4'><include path='gone.xml'/><BehaviorTree ID='T'><A/>"
      "</BehaviorTree></root>");
  EXPECT_EQ(Run({file_.path(), "-o", picture_}), 0);
  EXPECT_NE(errors_.find("gone.xml"), std::string::npos) << errors_;
}

TEST_F(ExportVerbTest, RunsAsAProgramWithoutADisplay) {
  const std::string program = BinaryFolder() + "/bin/coppice-export";
  StartedProgram run({program, file_.path(), "-o", picture_}, {"DISPLAY", "WAYLAND_DISPLAY"},
                     file_.folder() + "/errors");
  EXPECT_EQ(run.Wait(std::chrono::seconds(15)), 0);
  EXPECT_EQ(CountOf(Picture(), ">round</text>"), 1U);
}

}  // namespace
}  // namespace coppice::editor
