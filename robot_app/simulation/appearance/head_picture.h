// The head of a simulated person: hair, eyes, glasses, beard, mask, on a round head that turns.
#ifndef COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_HEAD_PICTURE_H_
#define COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_HEAD_PICTURE_H_

#include "robot_app/simulation/appearance/canvas.h"
#include "robot_app/simulation/appearance/person_look.h"

namespace coppice::robot::simulation {

/// Where a head is on the canvas.
struct HeadPlace {
  cv::Point2d middle;  ///< [pixels]
  double wide = 0;     ///< half of it, as it is turned [pixels]
  double tall = 0;     ///< half of it [pixels]
  double turn = 0;     ///< 0: looks at the camera; turned to the own left as positive [rad]
};

void PaintHead(const PersonLook& look, const HeadPlace& head, Canvas& canvas);

/// What of long hair hangs behind the shoulders, if it is long.
void PaintHairBehind(const PersonLook& look, const HeadPlace& head, Canvas& canvas);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_HEAD_PICTURE_H_
