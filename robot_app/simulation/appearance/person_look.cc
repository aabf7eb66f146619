#include "robot_app/simulation/appearance/person_look.h"

#include <array>
#include <random>

namespace coppice::robot::simulation {
namespace {

constexpr std::array<Colour, 6> kSkins = {{{244, 208, 182},
                                           {232, 190, 158},
                                           {208, 160, 124},
                                           {172, 122, 88},
                                           {128, 86, 60},
                                           {88, 58, 42}}};
constexpr std::array<Colour, 6> kHairs = {
    {{34, 26, 22}, {62, 42, 28}, {104, 70, 40}, {168, 128, 74}, {120, 118, 116}, {134, 60, 32}}};
constexpr std::array<Colour, 8> kTops = {{{178, 48, 44},
                                          {44, 84, 168},
                                          {46, 128, 74},
                                          {140, 60, 140},
                                          {228, 226, 220},
                                          {40, 42, 48},
                                          {214, 170, 60},
                                          {96, 120, 140}}};
constexpr std::array<Colour, 5> kTrousers = {
    {{44, 56, 92}, {36, 36, 40}, {120, 108, 86}, {84, 88, 94}, {70, 50, 40}}};
constexpr std::array<Colour, 4> kCaps = {
    {{40, 60, 120}, {30, 30, 32}, {150, 40, 40}, {206, 200, 186}}};
constexpr std::array<HairStyle, 9> kHairStyles = {
    {HairStyle::kShort, HairStyle::kShort, HairStyle::kShort, HairStyle::kFringe,
     HairStyle::kFringe, HairStyle::kLong, HairStyle::kLong, HairStyle::kBald, HairStyle::kCap}};
constexpr std::array<Beard, 8> kBeards = {{Beard::kNone, Beard::kNone, Beard::kNone, Beard::kNone,
                                           Beard::kNone, Beard::kMoustache, Beard::kStubble,
                                           Beard::kFull}};
constexpr std::array<MaskKind, 5> kMaskKinds = {{MaskKind::kSurgical, MaskKind::kSurgical,
                                                 MaskKind::kFolded, MaskKind::kFolded,
                                                 MaskKind::kCloth}};
constexpr std::array<Colour, 4> kSurgical = {
    {{150, 190, 214}, {126, 176, 210}, {164, 206, 196}, {222, 226, 228}}};
constexpr std::array<Colour, 4> kFolded = {
    {{236, 236, 234}, {226, 228, 230}, {44, 44, 48}, {240, 236, 226}}};
constexpr std::array<Colour, 6> kCloth = {
    {{38, 38, 42}, {60, 70, 110}, {140, 50, 56}, {96, 104, 96}, {196, 176, 150}, {180, 120, 150}}};

}  // namespace

PersonLook RandomPersonLook(std::uint64_t seed) {
  std::mt19937_64 random(seed * 0x9e3779b97f4a7c15U + 1);
  const auto one_of = [&](const auto& choices) { return choices[random() % choices.size()]; };
  PersonLook look;
  look.skin = one_of(kSkins);
  look.hair = one_of(kHairs);
  look.top = one_of(kTops);
  look.trousers = one_of(kTrousers);
  look.build = 0.88 + 0.01 * static_cast<double>(random() % 28);
  look.hair_style = one_of(kHairStyles);
  look.has_long_sleeves = random() % 3 != 0;
  look.beard = look.hair_style == HairStyle::kLong ? Beard::kNone : one_of(kBeards);
  look.has_glasses = random() % 4 == 0;
  look.cap = one_of(kCaps);
  look.mask_kind = one_of(kMaskKinds);
  look.mask = look.mask_kind == MaskKind::kSurgical ? one_of(kSurgical)
              : look.mask_kind == MaskKind::kFolded ? one_of(kFolded)
                                                    : one_of(kCloth);
  return look;
}

}  // namespace coppice::robot::simulation
