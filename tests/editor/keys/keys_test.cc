#include "editor/keys/keys.h"

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

TEST(Keys, AreReadAsTheyAreWrittenInAnyCase) {
  for (const KeyChord chord :
       {KeyChord{'O', kCtrl}, KeyChord{kKeyF1 + 11, kCtrl | kAlt | kShift},
        KeyChord{kKeyPageUp, kSuper}, KeyChord{'+', kCtrl}, KeyChord{kKeySpace}, KeyChord{}}) {
    const auto read = KeysFromString(ToString(chord));
    ASSERT_TRUE(read) << ToString(chord);
    EXPECT_EQ(*read, chord) << ToString(chord);
  }
  EXPECT_EQ(KeysFromString("shift+ctrl+del"), (KeyChord{kKeyDelete, kCtrl | kShift}));
  for (const char* wrong : {"Ctrl+", "Hyper+A", "AB", "F99", "Ctrl O", "key 400"}) {
    EXPECT_FALSE(KeysFromString(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace coppice::editor
