// What a simulated person looks like from day to day.
#ifndef COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_LOOK_H_
#define COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_LOOK_H_

#include <cstdint>

#include "robot_app/common/picture.h"

namespace coppice::robot::simulation {

enum class HairStyle : std::uint8_t { kShort, kFringe, kLong, kBald, kCap };
enum class Beard : std::uint8_t { kNone, kMoustache, kStubble, kFull };

/// Pleated as surgeons wear them, folded along the nose as FFP2, or of printed cloth.
enum class MaskKind : std::uint8_t { kSurgical, kFolded, kCloth };

struct PersonLook {
  Colour skin{222, 178, 148};
  Colour hair{60, 42, 30};
  Colour top{178, 48, 44};
  Colour trousers{50, 55, 80};
  Colour shoes{30, 28, 28};
  Colour cap{40, 60, 120};
  Colour mask{150, 190, 214};
  double build = 1;  ///< width of the trunk and the limbs, about 0.85..1.2
  HairStyle hair_style = HairStyle::kShort;
  Beard beard = Beard::kNone;
  MaskKind mask_kind = MaskKind::kSurgical;
  bool has_glasses = false;
  bool has_long_sleeves = true;
  bool wears_mask = false;        ///< over mouth and nose
  bool has_mask_at_chin = false;  ///< and neither mouth nor nose in it
};

/// One of many, with tones of skin, hair, clothes and masks as people have them; without a mask.
PersonLook RandomPersonLook(std::uint64_t seed);

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_APPEARANCE_PERSON_LOOK_H_
