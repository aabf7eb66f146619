#include "robot_app/localization/place_search.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <random>

#include "robot_app/localization/scan_matcher.h"
#include "tests/robot_app/navigation/world_robot.h"

namespace coppice::robot {
namespace {

TEST(PlaceSearch, Experiment) {
  const Floor floor = InstituteFloor();
  const LikelihoodField field(MapOf(floor));
  const PlaceSearch search(field);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> ux(-2, 51), uy(-6, 6), ua(-3.14, 3.14);
  int tries = 0;
  while (tries < 40) {
    const Pose2 pose{ux(random), uy(random), ua(random)};
    bool ok = true;
    for (double a = 0; a < 6.28; a += 0.3)
      ok = ok && field.Free(pose.x + 0.4 * cos(a), pose.y + 0.4 * sin(a));
    if (!ok) continue;
    ++tries;
    WorldOptions o;
    o.start = pose;
    o.seed = tries;
    World world(floor, o);
    const auto beams = BeamsOf(ScanOf(world), 0.12, 180);
    const auto t0 = std::chrono::steady_clock::now();
    const auto places = search.Find(beams, 8);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - t0).count();
    const Pose2D truth{pose.x, pose.y, pose.yaw};
    const Agreement at_truth = Agree(field, beams, truth);
    printf("(%6.2f %6.2f %6.2f) beams %zu truth a%d h%d t%d %.2f  %.1f ms:", pose.x, pose.y,
           pose.yaw, beams.size(), at_truth.agree, at_truth.hidden, at_truth.through,
           at_truth.score(), ms);
    for (const auto& p : places)
      printf("  %.2f%s", p.score,
             IsSamePlace(p.pose, truth)
                 ? ("*[" + std::to_string(Distance(p.pose, truth)) + "]").c_str()
                 : "");
    printf("\n");
  }
}

}  // namespace
}  // namespace coppice::robot
