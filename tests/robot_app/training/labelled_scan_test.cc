#include "robot_app/training/labelled_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coppice::robot::training {
namespace {

Site Square() {
  Site site;
  site.area = {{0, 0}, {16, 16}, 0};
  site.still.ceiling = 3;
  return site;
}

TEST(LabelledScan, TheSameSeedMeasuresTheSame) {
  std::mt19937_64 a(4), b(4);
  const LabelledScan first = MakeLabelledScan(Square(), {}, a);
  const LabelledScan second = MakeLabelledScan(Square(), {}, b);
  ASSERT_EQ(first.people.size(), second.people.size());
  ASSERT_EQ(first.points.size(), second.points.size());
  for (std::size_t i = 0; i < first.points.size(); ++i) {
    if (std::isnan(first.points[i].x)) continue;
    EXPECT_EQ(first.points[i].x, second.points[i].x);
  }
}

TEST(LabelledScan, WhereSomebodyIsInViewThereArePoints) {
  std::mt19937_64 random(7);
  int looked_at = 0;
  for (int i = 0; i < 20; ++i) {
    const LabelledScan scan = MakeLabelledScan(Square(), {}, random);
    for (const PersonTruth& person : scan.people) {
      const double distance = simulation::Length(person.position);
      if (person.visible < 0.9 || distance > 8) continue;
      ++looked_at;
      const auto near = std::count_if(scan.points.begin(), scan.points.end(), [&](const auto& p) {
        return std::hypot(p.x - person.position.x, p.y - person.position.y) < 0.4;
      });
      EXPECT_GT(near, 20) << distance;
    }
  }
  EXPECT_GT(looked_at, 20);
}

TEST(LabelledScan, HasPeopleInFullViewHalfHiddenHiddenAndInGroups) {
  std::mt19937_64 random(8);
  int full = 0, half = 0, hidden = 0, groups = 0;
  for (int i = 0; i < 40; ++i) {
    for (const PersonTruth& person : MakeLabelledScan(Square(), {}, random).people) {
      full += person.visible > 0.9 ? 1 : 0;
      half += person.visible > 0.3 && person.visible < 0.7 ? 1 : 0;
      hidden += person.visible < 0.1 ? 1 : 0;
      groups += person.in_group ? 1 : 0;
    }
  }
  for (const int count : {full, half, hidden, groups}) EXPECT_GT(count, 3);
}

}  // namespace
}  // namespace coppice::robot::training
