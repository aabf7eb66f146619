#include "editor/document/script_check.h"

#include <gmock/gmock.h>

namespace coppice::editor {
namespace {

TEST(ScriptCheck, IsSilentAboutAGoodScript) {
  EXPECT_EQ(ScriptProblemOf("battery < 20 && !docked"), "");
  EXPECT_EQ(ScriptProblemOf("count := count + 1; done := true"), "");
}

TEST(ScriptCheck, SaysWhereAScriptIsWrong) {
  EXPECT_THAT(ScriptProblemOf("battery < "), testing::StartsWith("column "));
  EXPECT_THAT(ScriptProblemOf("a b"), testing::StartsWith("column 3:"));
}

}  // namespace
}  // namespace coppice::editor
