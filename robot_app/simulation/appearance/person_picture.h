// Pictures of whole people for simulated cameras: drawn from a body with joints, so that they walk
// and can be seen from any side. The same look, view and size give the same picture, bit for bit.
#ifndef COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_PICTURE_H_
#define COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_PICTURE_H_

#include <array>
#include <cstdint>
#include <vector>

#include "robot_app/common/picture.h"

namespace coppice::robot::simulation {

/// What a person looks like from day to day.
struct PersonLook {
  Colour skin{222, 178, 148};
  Colour hair{60, 42, 30};
  Colour top{178, 48, 44};
  Colour trousers{50, 55, 80};
  Colour shoes{30, 28, 28};
  double build = 1;  ///< width of the trunk and the limbs, about 0.85..1.2
  bool has_long_hair = false;
  bool has_long_sleeves = true;
  bool wears_mask = false;  ///< over mouth and nose
};

/// One of many, with tones of skin, hair and clothes as people have them.
PersonLook RandomPersonLook(std::uint64_t seed);

/// How it is looked at.
struct PersonView {
  double turn = 0;  ///< 0: looks at the camera; turned to the own left as positive [rad]
  double step = 0;  ///< in which part of two steps the legs are [rad]
  bool walks = false;
};

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
