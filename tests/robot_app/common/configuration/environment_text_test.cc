#include "robot_app/common/configuration/environment_text.h"

#include <gtest/gtest.h>

namespace coppice::robot {
namespace {

std::optional<std::string> ValueOf(const std::string& name) {
  if (name == "HOST") return "example.org";
  if (name == "EMPTY") return "";
  return std::nullopt;
}

Expected<std::string> Fill(const std::string& text) { return FillVariables(text, ValueOf); }

TEST(FillVariables, PutsValuesAndDefaultsInTheirPlaces) {
  EXPECT_EQ(*Fill("https://${HOST}/x"), "https://example.org/x");
  EXPECT_EQ(*Fill("${PORT:-25}${HOST}"), "25example.org");
  EXPECT_EQ(*Fill("${EMPTY:-none}"), "none");
  EXPECT_EQ(*Fill("no variable, ${ not closed"), "no variable, ${ not closed");
}

TEST(FillVariables, NamesTheVariableThatIsMissing) {
  EXPECT_EQ(Fill("${HOST}${TOKEN}").problem(), "the environment variable TOKEN is not set");
  EXPECT_FALSE(Fill("${EMPTY}"));
}

TEST(IsVariable, IsTrueForOneVariableAlone) {
  EXPECT_TRUE(IsVariable("${COPPICE_TOKEN}"));
  for (const char* const other :
       {"", "secret", "${A}b", "a${B}", "${A}${B}", "${A:-secret}", "${}"}) {
    EXPECT_FALSE(IsVariable(other)) << other;
  }
}

}  // namespace
}  // namespace coppice::robot
