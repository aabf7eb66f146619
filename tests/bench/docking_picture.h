// A map of dockings: where each began, the way that it took, and how it ended.
#ifndef COPPICE_TESTS_BENCH_DOCKING_PICTURE_H_
#define COPPICE_TESTS_BENCH_DOCKING_PICTURE_H_

#include <string>
#include <vector>

#include "tests/robot_app/docking/docking_study.h"

namespace coppice::robot::docking {

/// An SVG file. A dot at every start: green if it docked at the first attempt, orange if at a later
/// one, red if not at all. The ways of the first hundred as thin lines; the landmark where each of
/// these found it. False if the file cannot be written.
bool DrawDockings(const std::vector<DockingOutcome>& outcomes, const std::string& file);

}  // namespace coppice::robot::docking

#endif  // COPPICE_TESTS_BENCH_DOCKING_PICTURE_H_
