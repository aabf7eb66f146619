#include "editor/commands/keys.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(Keys, HaveNamesAsOnTheKeyboard) {
  EXPECT_EQ(ToString(KeyChord{'O', kCtrl}), "Ctrl+O");
  EXPECT_EQ(ToString(KeyChord{kKeyF1 + 3}), "F4");
  EXPECT_EQ(ToString(KeyChord{kKeyPeriod}), ".");
  EXPECT_EQ(ToString(KeyChord{kKeyTab, kCtrl | kShift}), "Ctrl+Shift+Tab");
  EXPECT_EQ(ToString(KeyChord{}), "");
}

}  // namespace
}  // namespace coppice::editor
