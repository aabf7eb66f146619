#include "robot_app/simulation/scene/figure.h"

namespace coppice::robot::simulation {
namespace {

// Shares of the body's height and metres (Drillis and Contini 1966, rounded).
constexpr double kHip = 0.48;
constexpr double kHand = 0.42;
constexpr double kShoulder = 0.82;
constexpr double kLegRadius = 0.075;
constexpr double kTorsoRadius = 0.17;
constexpr double kArmRadius = 0.05;
constexpr double kHeadRadius = 0.1;
constexpr double kLegAside = 0.1;
constexpr double kArmAside = 0.22;
constexpr double kLegSwing = 0.22;  // m to the front and back
constexpr double kArmSwing = 0.15;
constexpr double kReach = 0.4;  // of a leg or arm, with its thickness
constexpr double kSkin = 0.5;   // reflectivity

}  // namespace

Figure MakeFigure(const Stance& stance) {
  const double swing = stance.walks ? std::sin(2 * kPi * stance.walked / kStride) : 0;
  const auto at = [&](double forward, double aside, double radius) {
    return Disc{stance.position + Rotated({forward, aside}, stance.heading), radius};
  };
  const double h = stance.height;
  const double c = stance.clothes;
  return {at(0, 0, kReach),
          {{{at(swing * kLegSwing, kLegAside, kLegRadius), 0, kHip * h, c},
            {at(-swing * kLegSwing, -kLegAside, kLegRadius), 0, kHip * h, c},
            {at(0, 0, kTorsoRadius), kHip * h, kShoulder * h, c},
            {at(-swing * kArmSwing, kArmAside, kArmRadius), kHand * h, kShoulder * h, c},
            {at(swing * kArmSwing, -kArmAside, kArmRadius), kHand * h, kShoulder * h, c},
            {at(0, 0, kHeadRadius), kShoulder * h, h, kSkin}}}};
}

std::vector<Figure> MakeFigures(const std::vector<Stance>& stances) {
  std::vector<Figure> figures;
  figures.reserve(stances.size());
  for (const Stance& stance : stances) figures.push_back(MakeFigure(stance));
  return figures;
}

std::vector<Disc> SlicesAt(double height, const std::vector<Figure>& figures) {
  std::vector<Disc> discs;
  for (const Figure& figure : figures) {
    for (const Pillar& part : figure.parts) {
      if (height >= part.bottom && height < part.top) discs.push_back(part.disc);
    }
  }
  return discs;
}

}  // namespace coppice::robot::simulation
