#include "editor/panels/field.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::HasSubstr;

class FieldTest : public testing::Test {
 protected:
  FieldTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
    driver_.Click("canvas/MainTree/1.1.2");
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }

  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(FieldTest, WhatIsTypedBecomesTheValueWithEnter) {
  ASSERT_TRUE(driver_.Click("inspector/port/lamp"));
  driver_.Press('A', kCtrl);
  driver_.Type("kitchen");
  EXPECT_THAT(Text(), HasSubstr("lamp=\"hall\""));
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr("lamp=\"kitchen\""));
  driver_.Picture("fields");
}

TEST_F(FieldTest, EscapeLeavesTheValueAlone) {
  ASSERT_TRUE(driver_.Click("inspector/port/lamp"));
  driver_.Press('A', kCtrl);
  driver_.Type("kitchen");
  driver_.Press(kKeyEscape);
  EXPECT_EQ(Text(), kSmallFile);
}

TEST_F(FieldTest, ButtonsFlipABoolAndStepANumber) {
  ASSERT_TRUE(driver_.Click("inspector/port/slowly/toggle"));
  EXPECT_THAT(Text(), HasSubstr("slowly=\"true\""));
  ASSERT_TRUE(driver_.Click("inspector/port/slowly/clear"));
  EXPECT_EQ(Text(), kSmallFile);
  driver_.view().Select(driver_.view().scene()->FindPath("1.2.1"));
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("inspector/port/num_attempts/more"));
  EXPECT_THAT(Text(), HasSubstr("num_attempts=\"4\""));
}

TEST_F(FieldTest, TabCompletesAKey) {
  ASSERT_TRUE(driver_.Click("inspector/port/lamp"));
  driver_.Press('A', kCtrl);
  driver_.Type("{le");
  EXPECT_TRUE(driver_.Has("inspector/port/lamp/completions"));
  driver_.Picture("completion");
  driver_.Press(kKeyTab);
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr("lamp=\"{level}\""));
}

TEST(Field, CompletesKeysOnlyWhereTheyCanStand) {
  FieldLook look;
  look.keys = {"goal", "gold", "speed"};
  EXPECT_THAT(Completions("{go", look), testing::ElementsAre("goal", "gold"));
  EXPECT_THAT(Completions("{", look), testing::SizeIs(3));
  EXPECT_THAT(Completions("go", look), testing::IsEmpty());
  EXPECT_THAT(Completions("{goal", look), testing::IsEmpty());
  look.is_script = true;
  EXPECT_THAT(Completions("x := sp", look), testing::ElementsAre("speed"));
  EXPECT_THAT(Completions("x := ", look), testing::IsEmpty());
}

TEST(Field, SuitsTheType) {
  EXPECT_EQ(KindOf("bool"), FieldKind::kBool);
  EXPECT_EQ(KindOf("double"), FieldKind::kNumber);
  EXPECT_EQ(KindOf("std::string"), FieldKind::kText);
}

TEST(Field, StepsKeepTheDecimals) {
  EXPECT_EQ(Stepped("3", 1), "4");
  EXPECT_EQ(Stepped("0.50", -1), "0.49");
  EXPECT_EQ(Stepped("-1", 1), "0");
  EXPECT_EQ(Stepped("{key}", 1), std::nullopt);
  EXPECT_EQ(Stepped("", 1), std::nullopt);
  EXPECT_EQ(Stepped("nan", 1), std::nullopt);
}

}  // namespace
}  // namespace coppice::editor
