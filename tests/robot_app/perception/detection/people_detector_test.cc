#include "robot_app/perception/detection/people_detector.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "robot_app/training/detection_figures.h"
#include "tests/robot_app/perception/detection/labelled_film.h"

namespace coppice::robot::perception {
namespace {

// More than half of them are smaller than the detector's window.
TEST(PeopleDetector, InAFilmThatNobodyHereMadeFindsThoseWhoAreLargeEnough) {
  const auto detector = MakePeopleDetector();
  training::DetectionFigures figures;
  const bool is_there = ShowFilm(4, [&](const LabelledFrame& frame) {
    figures.Add(frame.people, detector->Find(frame.picture));
  });
  if (!is_there) {
    std::printf("not tested: %s is missing (Debian's package opencv-doc)\n", kFilm);
    return;
  }
  EXPECT_GT(figures.there(), 70);
  EXPECT_GT(figures.recall(0.5), 0.3);
  EXPECT_GT(figures.precision(0.5), 0.6);
}

}  // namespace
}  // namespace coppice::robot::perception
