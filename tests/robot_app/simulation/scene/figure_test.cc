#include "robot_app/simulation/scene/figure.h"

#include <gtest/gtest.h>

namespace coppice::robot::simulation {
namespace {

Stance Walking(double walked) {
  Stance stance;
  stance.walks = true;
  stance.walked = walked;
  return stance;
}

TEST(Figure, IsAsHighAsThePerson) {
  Stance stance;
  stance.height = 1.6;
  double top = 0;
  for (const Pillar& part : MakeFigure(stance).parts) top = std::max(top, part.top);
  EXPECT_DOUBLE_EQ(top, 1.6);
}

TEST(Figure, LegsSwingAgainstEachOther) {
  const Figure figure = MakeFigure(Walking(0.35));
  EXPECT_GT(figure.parts[0].disc.center.x, 0.2);
  EXPECT_DOUBLE_EQ(figure.parts[0].disc.center.x, -figure.parts[1].disc.center.x);
}

TEST(Figure, WhoStandsHasBothLegsBelow) {
  Stance stance = Walking(0.35);
  stance.walks = false;
  EXPECT_EQ(MakeFigure(stance).parts[0].disc.center.x, 0);
}

TEST(Figure, AllPartsAreInsideItsBounds) {
  for (double walked = 0; walked < 1.4; walked += 0.1) {
    const Figure figure = MakeFigure(Walking(walked));
    for (const Pillar& part : figure.parts) {
      const double off = Length(part.disc.center - figure.bounds.center) + part.disc.radius;
      EXPECT_LE(off, figure.bounds.radius) << walked;
    }
  }
}

TEST(Figure, TurnsWithTheHeading) {
  Stance stance = Walking(0.35);
  stance.heading = kPi / 2;
  EXPECT_GT(MakeFigure(stance).parts[0].disc.center.y, 0.2);
}

TEST(Figure, ALevelPlaneCutsTwoLegsBelowTheHipsAndTorsoAndArmsAbove) {
  const std::vector<Figure> figures = MakeFigures({Walking(0.35)});
  const std::vector<Disc> legs = SlicesAt(0.3, figures);
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_NEAR(Length(legs[0].center - legs[1].center), 0.48, 0.01);
  EXPECT_EQ(SlicesAt(1.2, figures).size(), 3U);
  EXPECT_TRUE(SlicesAt(2, figures).empty());
}

}  // namespace
}  // namespace coppice::robot::simulation
