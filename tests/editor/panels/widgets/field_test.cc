#include "editor/panels/widgets/field.h"

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
  EXPECT_THAT(Text(), HasSubstr(R"(lamp="hall")"));
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(lamp="kitchen")"));
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
  EXPECT_THAT(Text(), HasSubstr(R"(slowly="true")"));
  ASSERT_TRUE(driver_.Click("inspector/port/slowly/clear"));
  EXPECT_EQ(Text(), kSmallFile);
  driver_.view().Select(driver_.view().scene()->FindPath("1.2.1"));
  driver_.Frames();
  ASSERT_TRUE(driver_.Click("inspector/port/num_attempts/more"));
  EXPECT_THAT(Text(), HasSubstr(R"(num_attempts="4")"));
}

TEST_F(FieldTest, TabCompletesAKey) {
  ASSERT_TRUE(driver_.Click("inspector/port/lamp"));
  driver_.Press('A', kCtrl);
  driver_.Type("{le");
  EXPECT_TRUE(driver_.Has("inspector/port/lamp/completions"));
  driver_.Picture("completion");
  driver_.Press(kKeyTab);
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(lamp="{level}")"));
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

class TypedFieldTest : public testing::Test {
 protected:
  TypedFieldTest() {
    driver_.editor.Open(file_.path());
    driver_.Frames();
    driver_.Click("canvas/Main/1");
  }
  const std::string& Text() {
    return driver_.editor.state().workspace.project().Find(file_.path())->text;
  }

  TemporaryFile file_{"drive.xml", R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main"><Drive to="1.5;2;0.5" gait="trot"/></BehaviorTree>
  <TreeNodesModel><Action ID="Drive"><input_port name="to" type="Pose2D">where to</input_port>
    <input_port name="from" type="Pose2D">where from</input_port>
    <input_port name="gait" type="Gait">how fast: walk, trot or gallop</input_port></Action>
  </TreeNodesModel>
</root>
)"};
  Driver driver_;
};

TEST_F(TypedFieldTest, APoseHasAFieldForEachNumber) {
  ASSERT_TRUE(driver_.Click("inspector/port/to/y"));
  driver_.Press('A', kCtrl);
  driver_.Type("-7.25");
  driver_.Press(kKeyEnter);
  EXPECT_THAT(Text(), HasSubstr(R"(to="1.5;-7.25;0.5")"));
  EXPECT_FALSE(driver_.Has("inspector/port/from/x")) << "it has no value yet";
  ASSERT_TRUE(driver_.Click("inspector/port/from/pose"));
  driver_.Frames();
  EXPECT_THAT(Text(), HasSubstr(R"(from="0;0;0")"));
  EXPECT_TRUE(driver_.Has("inspector/port/from/theta"));
  driver_.Picture("pose");
}

TEST_F(TypedFieldTest, TheNamesOfAnEnumAreOffered) {
  ASSERT_TRUE(driver_.Click("inspector/port/gait/choices"));
  driver_.Frames();
  ASSERT_TRUE(driver_.Has("inspector/port/gait/choice/walk"));
  ASSERT_TRUE(driver_.Click("inspector/port/gait/choice/gallop"));
  driver_.Frames();
  EXPECT_THAT(Text(), HasSubstr(R"(gait="gallop")"));
}

TEST(ChoicesIn, ReadsWhatManifestsSayAndNothingElse) {
  EXPECT_THAT(ChoicesIn("how fast: slow, fast or mad"),
              testing::ElementsAre("slow", "fast", "mad"));
  EXPECT_THAT(ChoicesIn("which: a or b"), testing::ElementsAre("a", "b"));
  for (const char* other : {"", "in lux", "where: here", "note: this, and more of it", "x: a, "}) {
    EXPECT_TRUE(ChoicesIn(other).empty()) << other;
  }
}

}  // namespace
}  // namespace coppice::editor
