// Pictures of whole people for simulated cameras: drawn from a body with joints, so that they walk
// and can be seen from any side. The same look, view and size give the same picture, bit for bit.
#ifndef COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_PICTURE_H_
#define COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_PICTURE_H_

#include <cstdint>
#include <vector>

#include "robot_app/simulation/appearance/person_look.h"

namespace coppice::robot::simulation {

/// How it is looked at.
struct PersonView {
  double turn = 0;  ///< 0: looks at the camera; turned to the own left as positive [rad]
  double step = 0;  ///< in which part of two steps the legs are [rad]
  bool walks = false;
};

/// Of the head, as shares of the person's height: how high its middle is, and half its sizes
/// upwards, sideways and forward.
inline constexpr double kHeadMiddle = 0.925;
inline constexpr double kHeadHalfTall = 0.075;
inline constexpr double kHeadHalfWide = 0.052;
inline constexpr double kHeadHalfLong = 0.063;

/// Half the width of a picture, as a share of the person's height.
inline constexpr double kPersonSide = 0.34;

/// Red, green, blue (each already weighed with the share) and which share of a pixel is covered.
/// The feet stand in the middle of the lower edge; `pixels_tall` pixels are the person's height.
struct PersonPicture {
  int width = 0;
  int height = 0;
  int pixels_tall = 0;
  std::vector<std::uint8_t> rgba;
};

PersonPicture DrawPerson(const PersonLook& look, const PersonView& view, int pixels_tall);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_PICTURE_H_
