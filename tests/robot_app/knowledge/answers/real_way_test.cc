#include "robot_app/knowledge/answers/real_way.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/folders.h"

namespace coppice::robot::knowledge {
namespace {

class RealWayTest : public testing::Test {
 protected:
  double SecondsTo(const std::string& id, std::optional<Point> at = std::nullopt) const {
    Place place;
    place.id = id;
    place.position.at = at;
    return RealWay(guide_, Pose2D{24, 0, 0})(place);
  }

  Diagnostics diagnostics_;
  RouteGuide guide_{*TopologicalMap::Load(
      SourceFolder() + "/robot_app/config/sites/institute/places.yaml", diagnostics_)};
};

// The robot stands in the corridor before 103.
TEST_F(RealWayTest, FollowsTheWaysOfTheMap) {
  EXPECT_LT(SecondsTo("office_103"), SecondsTo("office_104"));
  EXPECT_GT(SecondsTo("office_101"), 16 / 0.5);
}

TEST_F(RealWayTest, WhereNoEdgesLeadItTakesTwiceTheCrowsFlight) {
  EXPECT_DOUBLE_EQ(SecondsTo("library", Point{25, 0}), 2 * 1 / 0.5);
  EXPECT_TRUE(std::isinf(SecondsTo("moon")));
}

}  // namespace
}  // namespace coppice::robot::knowledge
