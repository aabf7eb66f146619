#include "robot_app/expression/expression_table.h"

#include <gmock/gmock.h>

#include <fstream>

#include "robot_app/common/robot_description.h"
#include "robot_app/expression/face_painter.h"
#include "robot_app/expression/face_texts.h"
#include "robot_app/expression/limbs.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::expression {
namespace {

using testing::HasSubstr;

const Colour kBlack{0, 0, 0};

class ExpressionTableTest : public testing::Test {
 protected:
  ExpressionTable Shipped() {
    ExpressionTable table =
        ReadExpressions(SourceFolder() + "/robot_app/expression/expressions.yaml", diagnostics_);
    EXPECT_FALSE(diagnostics_.has_errors()) << diagnostics_.ToString();
    return table;
  }
  // What is wrong with a file that says this of NEUTRAL.
  std::string Problems(const std::string& neutral) {
    const std::string path = folder_.path() + "/table.yaml";
    std::ofstream(path) << "NEUTRAL: " << neutral << "\n";
    ReadExpressions(path, diagnostics_);
    return diagnostics_.ToString();
  }

  TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(ExpressionTableTest, TheEyesAtRestAreRingsThatBlink) {
  const ExpressionTable table = Shipped();
  const Appearance& rest = table[Expression::NEUTRAL];
  const Picture open = PaintFace(FaceAt(rest, 1.0));
  EXPECT_EQ(open.at(15, 15), kBlack) << "a ring is hollow";
  EXPECT_NE(open.at(15, 5), kBlack);
  EXPECT_NE(open.at(48, 26), kBlack);
  const Picture closed = PaintFace(FaceAt(rest, 4.88));
  EXPECT_EQ(closed.at(15, 5), kBlack) << "a blink";
}

// The program crashed: of frames that are all shorter than those that are shown it had none.
TEST_F(ExpressionTableTest, AnExpressionOfShortFramesAloneIsPaintedAsWell) {
  ExpressionTable table = Shipped();
  const Picture shipped = Overview(table);
  table[Expression::NEUTRAL].face.resize(1);
  table[Expression::NEUTRAL].face[0].seconds = 0.02;
  const Picture overview = Overview(table);
  EXPECT_EQ(overview.width, shipped.width);
  EXPECT_EQ(overview.height, shipped.height);
}

TEST_F(ExpressionTableTest, WhoListensIsGreenWithEarsForwardAndWideEyes) {
  const ExpressionTable table = Shipped();
  const Appearance& listening = table[Expression::LISTENING];
  const LightStep lights = LightsAt(listening, 0);
  EXPECT_GT(lights.ears[1], 4 * lights.ears[0]);
  EXPECT_GT(lights.arms[1], 4 * lights.arms[2]);
  EXPECT_GT(LimbsAt(listening, 0)[0], 1.0);
  const auto height = [](const Appearance& appearance) {
    return appearance.face[0].eyes[0].numbers[3];
  };
  EXPECT_GT(height(listening), height(table[Expression::NEUTRAL]));
}

TEST_F(ExpressionTableTest, WhoIsSadLowersTheEarsAndWhoLaughsWigglesThem) {
  const ExpressionTable table = Shipped();
  EXPECT_LT(LimbsAt(table[Expression::SAD], 0)[0], -1.0);
  const Appearance& laughing = table[Expression::LAUGHING];
  EXPECT_LT(LimbsAt(laughing, 0.1)[0] * LimbsAt(laughing, 0.4)[0], 0);
}

TEST_F(ExpressionTableTest, NoLimbIsToldToGoWhereTheRobotCannot) {
  const auto robot = RobotDescription::Load(SourceFolder() + "/robot_app/description/sobi.urdf");
  const auto limbs = Limbs::Of(robot.value());
  ASSERT_TRUE(limbs) << limbs.problem();
  const ExpressionTable table = Shipped();
  for (std::size_t i = 0; i < leaves::kExpressionCount; ++i) {
    for (const LimbStep& step : table[static_cast<Expression>(i)].limbs) {
      for (std::size_t k = 0; k < kLimbs.size(); ++k) {
        EXPECT_GE(step.angles[k], limbs->joints()[k].lower) << i;
        EXPECT_LE(step.angles[k], limbs->joints()[k].upper) << i;
      }
    }
  }
}

TEST_F(ExpressionTableTest, BeginsAnewAtItsEnd) {
  Appearance two;
  two.face = {{1, {}, {}, {}}, {2, {}, {}, {}}};
  EXPECT_EQ(&FaceAt(two, 0.5), &two.face[0]);
  EXPECT_EQ(&FaceAt(two, 2.9), &two.face[1]);
  EXPECT_EQ(&FaceAt(two, 3.1), &two.face[0]);
}

TEST_F(ExpressionTableTest, LightsFadeFromStepToStep) {
  Appearance fade;
  fade.lights = {{1, {100, 0, 0}, {0, 0, 0}}, {1, {0, 0, 0}, {0, 0, 200}}};
  const LightStep half = LightsAt(fade, 0.5);
  EXPECT_EQ(half.arms, (Colour{50, 0, 0}));
  EXPECT_EQ(half.ears, (Colour{0, 0, 100}));
}

TEST_F(ExpressionTableTest, TellsWhereTheFileIsWrongAndWhatWasExpected) {
  const std::string problems = Problems(
      "{face: [{for: 1, eyes: [square 0 0 1 ffffff, ring 0 0 9 ffffff]}], lights: [{for: 1, arms: "
      "red}], limbs: [{for: 1, ears: up, arm: 0}]}");
  EXPECT_THAT(problems, HasSubstr("table.yaml:1:"));
  EXPECT_THAT(problems, HasSubstr("\"square\" is no shape"));
  EXPECT_THAT(problems, HasSubstr("ring X Y RX RY WIDTH COLOUR"));
  EXPECT_THAT(problems, HasSubstr("arms: expected a colour"));
  EXPECT_THAT(problems, HasSubstr("ears: expected a number"));
  EXPECT_THAT(problems, HasSubstr("arm"));
  EXPECT_THAT(problems, HasSubstr("expected the expression SAD"));
}

TEST_F(ExpressionTableTest, WantsAStepOfEachKind) {
  EXPECT_THAT(Problems("{lights: [{for: 1}], limbs: [{for: 1}]}"), HasSubstr("step of face"));
}

}  // namespace
}  // namespace coppice::robot::expression
