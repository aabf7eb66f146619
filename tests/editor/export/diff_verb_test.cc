#include "editor/export/diff_verb.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/editor/app/program.h"
#include "tests/editor/driver.h"
#include "tests/editor/export/painted.h"
#include "tests/support/folders.h"

namespace coppice::editor {
namespace {

constexpr char kBefore[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <RetryUntilSuccessful num_attempts="3"><OpenDoor/></RetryUntilSuccessful>
  <PickLock/>
</Sequence></BehaviorTree>
<BehaviorTree ID="Old"><AlwaysSuccess/></BehaviorTree></root>
)";
constexpr char kAfter[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Sequence>
  <RetryUntilSuccessful num_attempts="5"><OpenDoor/></RetryUntilSuccessful>
  <SmashDoor/>
</Sequence></BehaviorTree></root>
)";

class DiffVerbTest : public testing::Test {
 protected:
  int Run(std::vector<std::string> arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = RunDiff(arguments);
    output_ = testing::internal::GetCapturedStdout();
    errors_ = testing::internal::GetCapturedStderr();
    return code;
  }
  bool Says(const std::string& text) const { return output_.find(text) != std::string::npos; }

  TemporaryFile a_{"a.xml", kBefore};
  TemporaryFile b_{"b.xml", kAfter};
  const std::string picture_ = b_.folder() + "/diff.svg";
  std::string output_, errors_;
};

TEST_F(DiffVerbTest, SaysWhatChangedAndWhere) {
  EXPECT_EQ(Run({a_.path(), b_.path()}), 1) << errors_;
  EXPECT_TRUE(Says("~ 1.1 RetryUntilSuccessful: num_attempts \"3\" -> \"5\"   " + b_.path() + ":2"))
      << output_;
  EXPECT_TRUE(Says("1.2 SmashDoor")) << output_;
  EXPECT_TRUE(Says("- tree Old\n")) << output_;
  EXPECT_FALSE(Says("OpenDoor")) << output_;
  EXPECT_FALSE(Says("\x1b")) << "no colours in a pipe";
}

TEST_F(DiffVerbTest, SaysNothingAboutTheSameTrees) {
  EXPECT_EQ(Run({a_.path(), a_.path(), "-o", picture_}), 0);
  EXPECT_EQ(output_, "");
  EXPECT_FALSE(std::filesystem::exists(picture_));
}

TEST_F(DiffVerbTest, PaintsTheDifference) {
  EXPECT_EQ(Run({a_.path(), b_.path(), "-o", picture_}), 1) << errors_;
  const std::string svg = ReadFile(picture_);
  EXPECT_EQ(CountOf(svg, ">3 \u2192 5</text>"), 1U);
  EXPECT_EQ(CountOf(svg, ">Old: 1 removed</text>"), 1U);
}

TEST_F(DiffVerbTest, EndsWithTwoIfItCannotCompare) {
  EXPECT_EQ(Run({a_.path()}), 2);
  EXPECT_NE(errors_.find("expected A.xml B.xml"), std::string::npos);
  EXPECT_EQ(Run({a_.path(), "/nowhere.xml"}), 2);
  EXPECT_NE(errors_.find("/nowhere.xml"), std::string::npos);
  EXPECT_EQ(Run({a_.path(), b_.path(), "-o", "x.gif"}), 2);
  EXPECT_EQ(Run({a_.path(), b_.path(), "-o", "/nowhere/x.svg"}), 2);
}

TEST_F(DiffVerbTest, RunsAsAProgram) {
  const std::string program = BinaryFolder() + "/bin/coppice-diff";
  StartedProgram run({program, a_.path(), b_.path(), "-o", picture_},
                     {"DISPLAY", "WAYLAND_DISPLAY"}, b_.folder() + "/errors");
  EXPECT_EQ(run.Wait(std::chrono::seconds(15)), 1);
  EXPECT_TRUE(std::filesystem::exists(picture_));
}

}  // namespace
}  // namespace coppice::editor
