#include "editor/panels/xml/xml_keys.h"

#include <gtest/gtest.h>

namespace coppice::editor {
namespace {

TEST(XmlKeys, LeaveTheKeysOfCommandsAlone) {
  EXPECT_TRUE(IsTextKey({'D', kNoModifier}));
  EXPECT_TRUE(IsTextKey({kKeyDelete, kNoModifier}));
  EXPECT_TRUE(IsTextKey({'V', kCtrl}));
  EXPECT_FALSE(IsTextKey({'Z', kCtrl}));
  EXPECT_FALSE(IsTextKey({'S', kCtrl}));
  EXPECT_FALSE(IsTextKey({kKeyF1, kNoModifier}));
  EXPECT_FALSE(IsTextKey({kKeyUp, kAlt}));
}

TEST(XmlKeys, CutAndPaste) {
  std::string board;
  const TextClipboard clipboard = {[&] { return board; },
                                   [&](const std::string& text) { board = text; }};
  TextEdit edit{"abc", 0, 0};
  PressTextKey({kKeyRight, kShift}, clipboard, edit);
  PressTextKey({'X', kCtrl}, clipboard, edit);
  EXPECT_EQ(edit.text, "bc");
  PressTextKey({kKeyEnd, kNoModifier}, clipboard, edit);
  PressTextKey({'V', kCtrl}, clipboard, edit);
  EXPECT_EQ(edit.text, "bca");
  PressTextKey({kKeyBackspace, kNoModifier}, clipboard, edit);
  PressTextKey({kKeyTab, kNoModifier}, clipboard, edit);
  EXPECT_EQ(edit.text, "bc  ");
}

}  // namespace
}  // namespace coppice::editor
