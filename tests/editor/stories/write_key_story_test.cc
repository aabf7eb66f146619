#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

constexpr char kFile[] = R"(<root BTCPP_format="4"><BehaviorTree ID="Patrol"><Sequence>
  <Script code="half := 0.5; place := 'lab'"/><Go/></Sequence></BehaviorTree></root>)";

class WriteKeyStory : public testing::Test {
 protected:
  WriteKeyStory() : file_("patrol.xml", kFile) {
    driver_.editor.Open(file_.path());
    driver_.Frames(8);
    driver_.Press(kKeyF1 + 4);
    driver_.Press(kKeyF1 + 9);
    driver_.Frames(4);
  }
  void DoubleClick(const std::string& item) {
    ASSERT_TRUE(driver_.Click(item));
    ASSERT_TRUE(driver_.Click(item));
  }
  void Write(const std::string& key, const std::string& value) {
    DoubleClick("blackboard/Patrol/" + key);
    driver_.Type(value);
    driver_.Press(kKeyEnter);
    driver_.Frames();
  }
  std::string ValueOf(const std::string& key) {
    return driver_.editor.state().simulator.get()->ValueOf(key);
  }

  const TemporaryFile file_;
  Driver driver_;
};

TEST_F(WriteKeyStory, TheFieldBeginsWithThePresentValue) {
  DoubleClick("blackboard/Patrol/half");
  EXPECT_EQ(driver_.editor.state().popup.text, "0.5");
}

TEST_F(WriteKeyStory, WhatWasWrittenWaitsForTheNextTick) {
  Write("half", "2");
  EXPECT_TRUE(driver_.Has("blackboard/waiting/Patrol/half"));
  driver_.Picture("waits");
  driver_.Press(kKeyF1 + 9);
  driver_.Frames(4);
  EXPECT_FALSE(driver_.Has("blackboard/waiting/Patrol/half"));
  EXPECT_EQ(ValueOf("half"), "2");
}

TEST_F(WriteKeyStory, ATextOfDigitsStaysAText) {
  Write("place", "12");
  driver_.Press(kKeyF1 + 9);
  driver_.Frames(4);
  EXPECT_EQ(ValueOf("place"), "12");
}

TEST_F(WriteKeyStory, WhatIsNoValueOfTheTypeIsRefusedInTheField) {
  Write("half", "much");
  EXPECT_EQ(driver_.editor.state().popup.kind, Popup::kPrompt);
  EXPECT_FALSE(driver_.Has("blackboard/waiting/Patrol/half"));
}

}  // namespace
}  // namespace coppice::editor
