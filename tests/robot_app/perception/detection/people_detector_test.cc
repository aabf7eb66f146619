#include "robot_app/perception/detection/people_detector.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "robot_app/training/detection_figures.h"
#include "tests/robot_app/perception/detection/labelled_film.h"

namespace coppice::robot::perception {
namespace {

void SayThatItIsMissing() {
  std::printf("not tested: %s is missing (Debian's package opencv-doc)\n", kFilm);
}

// More than half of them are smaller than the detector's window.
TEST(PeopleDetector, InAFilmThatNobodyHereMadeFindsThoseWhoAreLargeEnough) {
  const auto detector = MakePeopleDetector();
  training::DetectionFigures figures;
  const bool is_there = ShowFilm(4, [&](const LabelledFrame& frame) {
    figures.Add(frame.people, detector->Find(frame.picture));
  });
  if (!is_there) return SayThatItIsMissing();
  EXPECT_GT(figures.there(), 70);
  EXPECT_GT(figures.recall(0.5), 0.3);
  EXPECT_GT(figures.precision(0.5), 0.6);
}

// In every frame: people who stand 1 m before the camera and are 10 cm tall.
TEST(PeopleDetector, LeavesOutWhatIsTooSmallForAPersonWhereItIs) {
  const auto detector = MakePeopleDetector();
  const bool is_there = ShowFilm(20, [&](const LabelledFrame& frame) {
    DepthPicture depth(frame.picture.width, frame.picture.height);
    EXPECT_FALSE(detector->Find({frame.picture, &depth, 800}).empty()) << "nothing is measured";
    for (std::uint16_t& value : depth.millimetres) value = 1000;
    EXPECT_TRUE(detector->Find({frame.picture, &depth, 800}).empty());
  });
  if (!is_there) SayThatItIsMissing();
}

}  // namespace
}  // namespace coppice::robot::perception
