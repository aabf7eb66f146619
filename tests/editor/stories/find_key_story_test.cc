// A key is found among many, by its name or by its value.
#include <gtest/gtest.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

class FindKeyStory : public testing::Test {
 protected:
  FindKeyStory() {
    for (int i = 0; i < 10; ++i) {
      robot_->Write("Main", "key" + std::to_string(i), "value" + std::to_string(i));
    }
    robot_->Write("Main", "map", std::string(50'000, 'x'));
    driver_.Frames(4);
  }
  void Search(const std::string& words) {
    ASSERT_TRUE(driver_.Has("blackboard/Main/key6")) << "before";
    ASSERT_TRUE(driver_.Click("blackboard/search"));
    driver_.Type(words);
    driver_.Frames();
  }

  Driver driver_;
  ScriptedRobot* const robot_ = driver_.AddRobot("robot:1", kLiveTree);
};

TEST_F(FindKeyStory, WordsOfTheValueFindIt) {
  Search("value7");
  EXPECT_TRUE(driver_.Has("blackboard/Main/key7"));
  EXPECT_FALSE(driver_.Has("blackboard/Main/key6"));
  driver_.Picture("find_key");
}

TEST_F(FindKeyStory, WordsOfThePathFindIt) {
  Search("main KEY3");
  EXPECT_TRUE(driver_.Has("blackboard/Main/key3"));
  EXPECT_FALSE(driver_.Has("blackboard/Main/key6"));
}

TEST_F(FindKeyStory, ALargeValueIsFoundByItsPath) {
  Search("map");
  driver_.MoveTo(driver_.BoxOf("blackboard/Main/map").center());
  driver_.Frames();
  driver_.Picture("large_value");
  EXPECT_TRUE(driver_.Has("blackboard/Main/map"));
  EXPECT_FALSE(driver_.Has("blackboard/Main/key6"));
}

}  // namespace
}  // namespace coppice::editor
