#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

// All of it comes before the next frame, as on a slow screen.
class QuickHandsStory : public testing::Test {
 protected:
  QuickHandsStory() {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
    driver_.Click("canvas/MainTree/1");
  }
  void Press(Key key, const std::string& text) {
    driver_.input.events.push_back(KeyEvent{key, true, kNoModifier});
    if (!text.empty()) driver_.input.events.push_back(TypedText{text});
    driver_.input.events.push_back(KeyEvent{key, false, kNoModifier});
  }
  const std::string& Typed() { return driver_.editor.state().popup.text; }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(QuickHandsStory, WhatIsTypedRightAfterTheKeyOfAPopupIsInItsField) {
  Press(kKeyTab, "");
  Press('W', "w");
  Press('A', "a");
  Press('I', "i");
  driver_.Frames(8);
  ASSERT_EQ(driver_.editor.state().popup.kind, Popup::kAdd);
  EXPECT_EQ(Typed(), "wai");
}

TEST_F(QuickHandsStory, TheLetterOfTheKeyItselfIsNotInTheField) {
  Press('R', "r");  // change the type
  Press('D', "d");
  driver_.Frames(8);
  ASSERT_EQ(driver_.editor.state().popup.kind, Popup::kChangeType);
  EXPECT_EQ(Typed(), "d");
}

TEST_F(QuickHandsStory, APopupWithoutAFieldKeepsNothingForTheNextOne) {
  Press('D', "d");  // disables: something to save
  driver_.Press('Q', kCtrl);
  Press('Z', "z");
  driver_.Frames(8);
  driver_.Press(kKeyEscape);
  driver_.Frames(4);
  driver_.Press(kKeyTab);
  driver_.Frames(8);
  EXPECT_EQ(Typed(), "");
}

}  // namespace
}  // namespace coppice::editor
