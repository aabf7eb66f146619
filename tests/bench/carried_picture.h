// Where a robot that was put anywhere found out where it is, as a picture: the floor from above,
// once for each study, one below the other.
#ifndef COPPICE_TESTS_BENCH_CARRIED_PICTURE_H_
#define COPPICE_TESTS_BENCH_CARRIED_PICTURE_H_

#include <string>
#include <vector>

#include "robot_app/simulation/floor.h"
#include "tests/robot_app/slam/carried_study.h"

namespace coppice::robot::slam {

struct DrawnStudy {
  std::string name;
  std::vector<CarriedOutcome> outcomes;
};

/// SVG. A place is green where it was found, orange where the robot said that it does not know,
/// red where it took another place for it. False: the file cannot be written.
bool DrawCarried(const simulation::Floor& floor, const std::vector<DrawnStudy>& studies,
                 const std::string& file);

}  // namespace coppice::robot::slam

#endif  // COPPICE_TESTS_BENCH_CARRIED_PICTURE_H_
