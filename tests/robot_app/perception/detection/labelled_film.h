// A film that nobody here made, with the people in it: vtest.avi of Debian's package opencv-doc,
// 768 x 576 pixels, pedestrians seen from a fixed camera above them. vtest_people.csv beside this
// file says who is where in 60 of its frames.
#ifndef COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_LABELLED_FILM_H_
#define COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_LABELLED_FILM_H_

#include <functional>
#include <vector>

#include "robot_app/common/picture.h"
#include "robot_app/perception/detection/sighting.h"

namespace coppice::robot::perception {

inline constexpr char kFilm[] = "/usr/share/doc/opencv-doc/examples/data/vtest.avi";

struct LabelledFrame {
  int number = 0;  ///< of the film's frames, from 0
  Picture picture;
  std::vector<Sighting> people;  ///< of confidence 0: to see him or not counts neither way
};

/// Shows every `step`-th of the labelled frames; false: the film is not installed.
bool ShowFilm(int step, const std::function<void(const LabelledFrame&)>& show);

}  // namespace coppice::robot::perception

#endif  // COPPICE_TESTS_ROBOT_APP_PERCEPTION_DETECTION_LABELLED_FILM_H_
