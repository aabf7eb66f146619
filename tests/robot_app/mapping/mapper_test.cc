#include "robot_app/mapping/mapper.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "robot_app/mapping/map_file.h"
#include "tests/robot_app/mapping/mapped_robot.h"

namespace coppice::robot {
namespace {

TEST(Mapper, Scratch) {
  for (BadOdometry bad : {BadOdometry{}, BadOdometry{0.02, 0.005}, BadOdometry{0.05, 0.02}}) {
    Floor floor = InstituteFloor();
    MappedRobot robot(floor, {-0.5, 0, 0}, 1, bad);
    auto t0 = std::chrono::steady_clock::now();
    bool ok = robot.Drive(RoundOfTheInstitute());
    const MappingReport report = robot.mapper().Report();
    std::printf(
        "ok %d at %.2f %.2f, way %.1f frames %zu loops %zu error %.3f max %.3f odo %.2f score %.2f "
        "cpu %.1f s sim %.0f\n",
        ok, robot.Truth().x, robot.Truth().y, report.way, report.key_frames, report.loops,
        robot.Error(), robot.farthest_off(),
        Distance(Compose(Pose2D{-0.5, 0, 0}, robot.Odometry2D()), robot.Truth()), report.score,
        std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count(), robot.now());
    Diagnostics d;
    SaveMap(bad.twisted == 0     ? "/tmp/w/map_a.yaml"
            : bad.twisted < 0.01 ? "/tmp/w/map_b.yaml"
                                 : "/tmp/w/map_c.yaml",
            robot.mapper().Map(), d);
  }
}

}  // namespace
}  // namespace coppice::robot
