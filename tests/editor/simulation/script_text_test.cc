#include "editor/simulation/script_text.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

std::string Again(const std::string& text) {
  const Expected<MockScript> script = ParseScript(text);
  return script ? PrintScript(*script) : script.problem();
}

TEST(ScriptText, SaysWhatALeafDoes) {
  EXPECT_EQ(Again("SUCCESS"), "SUCCESS");
  EXPECT_EQ(Again("2s FAILURE"), "2s FAILURE");
  EXPECT_EQ(Again("RUNNING x3, SUCCESS"), "RUNNING x3 SUCCESS");
  EXPECT_EQ(Again("each r r f"), "each RUNNING x2 FAILURE");
  EXPECT_EQ(Again("0.25s"), "250ms SUCCESS");
  EXPECT_EQ(Again("sk"), "SKIPPED");
}

TEST(ScriptText, SaysWhatALeafDoesByChance) {
  EXPECT_EQ(Again("80% SUCCESS 20% FAILURE 0s..2s"), "80% SUCCESS 20% FAILURE 0ms..2s");
  EXPECT_EQ(Again("1% f, 1% s, 2% sk"), "25% SUCCESS 25% FAILURE 50% SKIPPED");
  EXPECT_EQ(Again("100% FAILURE 1s"), "100% FAILURE 1s..1s");
  EXPECT_EQ(Again("100% f 0s..1s holds 5s"), "100% FAILURE 0ms..1s holds 5s..5s");
  EXPECT_EQ(Again("100% f holds 0s..5s"), "100% FAILURE holds 0ms..5s");
  EXPECT_NE(Again("100% f holds").find(R"("holds")"), std::string::npos);
  EXPECT_NE(Again("100% f holds long").find(R"("long")"), std::string::npos);
  EXPECT_NE(Again("80%").find("after a share"), std::string::npos);
  EXPECT_NE(Again("80% RUNNING").find("after a share"), std::string::npos);
  EXPECT_NE(Again("0% SUCCESS").find("say of what"), std::string::npos);
  EXPECT_NE(Again("80% SUCCESS 2s..1s").find(R"("2s..1s")"), std::string::npos);
}

TEST(ScriptText, SaysWhatItDoesNotUnderstand) {
  EXPECT_NE(Again("2s FAIL quickly").find(R"("quickly" is no SUCCESS)"), std::string::npos);
  EXPECT_NE(Again("").find("say what it returns"), std::string::npos);
  EXPECT_NE(Again("x3").find(R"("x3")"), std::string::npos);
  EXPECT_NE(Again("1e99s").find(R"("1e99s")"), std::string::npos);
  EXPECT_NE(Again("RUNNING x9999 RUNNING x9999").find("more than"), std::string::npos);
}

}  // namespace
}  // namespace coppice::editor
