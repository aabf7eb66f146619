// Names in the writing of the team: Chinese, Japanese, Korean, Russian, Greek.
#include <gtest/gtest.h>

#include <string>

#include "editor/theme/imgui_context.h"
#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kTree[] = R"(<root BTCPP_format="4" main_tree_to_execute="巡逻">
<BehaviorTree ID="巡逻"><Sequence name="检查电量">
<Sleep name="充電を待つ" msec="100"/><Sleep name="문을 열다" msec="100"/>
<Sleep name="Ждать у двери" msec="100"/><Sleep name="στροφή" msec="100"/>
</Sequence></BehaviorTree></root>)";

class LanguagesStory : public testing::Test {
 protected:
  // Whether all of the text is written with letters, none with a box.
  bool CanRead(const std::string& text) const {
    const WithContext current(driver_.editor.context());
    for (const ImFont* const font : ImGui::GetIO().Fonts->Fonts) {
      for (const ImWchar code : UnusualCharacters(text)) {
        if (!font->FindGlyphNoFallback(code)) return false;
      }
    }
    return true;
  }
  double Now() const { return driver_.editor.now(); }

  Driver driver_{[] {
    EditorOptions options;
    options.fonts = std::make_shared<const Fonts>(1);  // as a window begins
    return options;
  }()};
};

TEST_F(LanguagesStory, ATreeIsReadInWhateverLanguageItWasWritten) {
  const TemporaryFile file("patrol.xml", kTree);
  driver_.editor.Open(file.path());
  driver_.Frames(20);
  driver_.Picture("languages");
  EXPECT_TRUE(CanRead(kTree));
}

TEST_F(LanguagesStory, ANameIsSeenAsItIsTyped) {
  const TemporaryFile file("small.xml", kSmallFile);
  driver_.editor.Open(file.path());
  driver_.Frames(20);
  driver_.Click("canvas/MainTree/1");
  driver_.Press(kKeyF1 + 1);
  driver_.Type("дверь");
  driver_.Frames(10);
  EXPECT_TRUE(CanRead("дверь"));
}

TEST_F(LanguagesStory, WhatARobotSendsIsReadASecondLaterAtMost) {
  ScriptedRobot* const robot = driver_.AddRobot("robot:1", kLiveTree);
  robot->Write("Main", "room", "实验室");
  driver_.Frames(10);
  EXPECT_TRUE(CanRead("实验室"));
  robot->Write("Main", "room", "走廊");
  const double sent = Now();
  while (!CanRead("走廊") && Now() < sent + 2) driver_.Frames(1);
  EXPECT_LE(Now(), sent + 1.1);
}

}  // namespace
}  // namespace coppice::editor
