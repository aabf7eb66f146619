#include "robot_app/simulation/appearance/head_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr Colour kEyeWhite{235, 232, 228};
constexpr Colour kIris{40, 30, 26};
constexpr Colour kLips{150, 70, 66};
constexpr Colour kFrame{36, 32, 34};
constexpr Colour kPrint{236, 230, 214};

constexpr double kSideOfHead = CV_PI / 2;

// Places on the head: how far around it from the nose, to the own left as positive [rad], and how
// far below its middle, as a share of half its height.
using OnHead = std::pair<double, double>;

class HeadPainter {
 public:
  HeadPainter(const PersonLook& look, const HeadPlace& head, Canvas& canvas)
      : look_(look), head_(head), canvas_(canvas) {}

  void Paint() {
    canvas_.Ellipse(head_.middle, {wide(), tall()}, look_.skin, 0.75);
    canvas_.Ellipse(head_.middle - cv::Point2d(0.12 * wide(), 0), {0.84 * wide(), 0.95 * tall()},
                    look_.skin);
    for (const double side : {-kSideOfHead, kSideOfHead}) PaintEar(side);
    if (std::cos(head_.turn) > -0.2) PaintFace();
    PaintHair();
    if (look_.has_glasses) PaintGlasses();
  }

 private:
  double wide() const { return head_.wide; }
  double tall() const { return head_.tall; }

  // How much of something there is turned towards the camera; what is below 0 is behind the head.
  double Facing(double around) const { return std::cos(around + head_.turn); }

  // What is behind the head is put on its rim.
  cv::Point2d At(double around, double down) const {
    const double angle = std::clamp(around + head_.turn, -kSideOfHead, kSideOfHead);
    const double ring = std::sqrt(std::max(0.0, 1 - 0.8 * down * down));
    return head_.middle + cv::Point2d(std::sin(angle) * ring * wide(), down * tall());
  }
  std::vector<cv::Point2d> At(const std::vector<OnHead>& places) const {
    std::vector<cv::Point2d> points;
    for (const auto& [around, down] : places) points.push_back(At(around, down));
    return points;
  }

  void Spot(double around, double down, double half_wide, double half_tall, const Colour& colour,
            double light = 1) {
    const double facing = Facing(around);
    if (facing < 0.12) return;
    canvas_.Ellipse(At(around, down), {half_wide * facing * wide(), half_tall * tall()}, colour,
                    light);
  }

  void PaintEar(double side) {
    if (Facing(side) < -0.2) return;
    canvas_.Ellipse(At(side, 0.05) + cv::Point2d(0.02 * (side > 0 ? wide() : -wide()), 0),
                    {0.12 * wide(), 0.17 * tall()}, look_.skin, 0.8);
  }

  void PaintFace() {
    for (const double eye : {-0.42, 0.42}) {
      Spot(eye, -0.1, 0.24, 0.12, look_.skin, 0.85);
      Spot(eye, -0.08, 0.19, 0.08, kEyeWhite);
      Spot(eye, -0.08, 0.09, 0.085, kIris);
      Spot(eye, -0.24, 0.26, 0.05, look_.hair, 0.8);
    }
    PaintNose();
    Spot(0, 0.52, 0.32, 0.065, kLips);
    PaintBeard();
    if (look_.wears_mask) {
      PaintMask(0.04, 0.96);
    } else if (look_.has_mask_at_chin) {
      PaintMask(0.66, 1.12);
    }
  }

  // It stands out, so that it moves farther than the rest when the head turns.
  void PaintNose() {
    const cv::Point2d root = At(0, -0.06);
    const cv::Point2d foot = At(0, 0.28);
    const cv::Point2d tip = foot + cv::Point2d(0.2 * std::sin(head_.turn) * wide(), 0);
    if (Facing(0) > 0.1) canvas_.Line({root, tip}, 0.07 * wide(), look_.skin, 0.86);
    canvas_.Polygon({root, tip, foot}, look_.skin, 0.9);
    canvas_.Ellipse(tip, {0.14 * wide(), 0.07 * tall()}, look_.skin, 0.76);
  }

  void PaintBeard() {
    if (look_.beard == Beard::kNone) return;
    if (look_.beard == Beard::kMoustache || look_.beard == Beard::kFull) {
      Spot(0, 0.41, 0.36, 0.07, look_.hair, 0.9);
    }
    if (look_.beard == Beard::kMoustache) return;
    Colour colour = look_.hair;
    if (look_.beard == Beard::kStubble) {
      for (std::size_t i = 0; i < 3; ++i) {
        colour[i] = static_cast<std::uint8_t>((2 * look_.skin[i] + look_.hair[i]) / 3);
      }
    }
    canvas_.Polygon(At({{-1.35, 0.1},
                        {-1.0, 0.5},
                        {-0.45, 0.62},
                        {0, 0.6},
                        {0.45, 0.62},
                        {1.0, 0.5},
                        {1.35, 0.1},
                        {1.2, 0.7},
                        {0.6, 0.98},
                        {0, 1.04},
                        {-0.6, 0.98},
                        {-1.2, 0.7}}),
                    colour, 0.92);
  }

  // From `top` on the nose to `bottom` under the chin.
  void PaintMask(double top, double bottom) {
    const double side = top + 0.14;
    const double jaw = bottom - 0.26;
    for (const double ear : {-1.45, 1.45}) {
      if (Facing(ear) < 0) continue;
      const double rim = ear > 0 ? 1.05 : -1.05;
      canvas_.Line({At(rim, side), At(ear, 0.0)}, 0.05 * wide(), kEyeWhite);
      canvas_.Line({At(rim, jaw), At(ear, 0.12)}, 0.05 * wide(), kEyeWhite);
    }
    const bool is_folded = look_.mask_kind == MaskKind::kFolded;
    const double beak = is_folded ? 0.16 * std::sin(head_.turn) * wide() : 0;
    std::vector<cv::Point2d> outline = At({{-1.1, side},
                                           {-0.4, top + 0.06},
                                           {0, top},
                                           {0.4, top + 0.06},
                                           {1.1, side},
                                           {1.05, jaw},
                                           {0.5, bottom - 0.05},
                                           {0, bottom},
                                           {-0.5, bottom - 0.05},
                                           {-1.05, jaw}});
    if (beak != 0)
      outline.insert(outline.begin() + 3, At(0, (top + bottom) / 2) + cv::Point2d(beak, 0));
    canvas_.Polygon(outline, look_.mask, 0.82);
    canvas_.Polygon(At({{-1.05, side + 0.03},
                        {-0.4, top + 0.09},
                        {0, top + 0.04},
                        {0.25, side},
                        {0.3, jaw},
                        {0, bottom - 0.06},
                        {-0.5, bottom - 0.1},
                        {-1, jaw - 0.03}}),
                    look_.mask);
    PaintMaskSurface(top, bottom);
  }

  void PaintMaskSurface(double top, double bottom) {
    const double middle = (top + bottom) / 2;
    const double high = bottom - top;
    switch (look_.mask_kind) {
      case MaskKind::kSurgical:
        for (const double share : {-0.16, 0.0, 0.16}) {
          const double down = middle + share * high;
          canvas_.Line(At({{-1.05, down - 0.04}, {0, down}, {1.05, down - 0.04}}), 0.035 * wide(),
                       look_.mask, 0.72);
        }
        return;
      case MaskKind::kFolded:
        canvas_.Line(At({{0, top}, {0, bottom}}), 0.05 * wide(), look_.mask, 0.66);
        return;
      case MaskKind::kCloth:
        for (int row = 0; row < 3; ++row) {
          for (int column = -2; column <= 2; ++column) {
            const double around = 0.36 * column + (row % 2 == 0 ? 0.18 : 0);
            Spot(around, middle + high * 0.2 * (row - 1), 0.07, 0.045, kPrint);
          }
        }
        return;
    }
  }

  void PaintHair() {
    if (look_.hair_style == HairStyle::kCap) return PaintCap();
    if (look_.hair_style == HairStyle::kBald) return;
    const double facing = std::cos(head_.turn);
    if (facing < -0.2) {
      canvas_.Ellipse(head_.middle - cv::Point2d(0, 0.08 * tall()), {1.04 * wide(), 0.96 * tall()},
                      look_.hair, 0.85);
      return;
    }
    const double brow = look_.hair_style == HairStyle::kFringe ? -0.3 : -0.58;
    canvas_.Polygon(At({{-1.57, brow + 0.1},
                        {-0.8, brow},
                        {0, brow - 0.06},
                        {0.8, brow},
                        {1.57, brow + 0.1},
                        {1.57, -0.7},
                        {0, -0.9},
                        {-1.57, -0.7}}),
                    look_.hair, 0.85);
    canvas_.Ellipse(head_.middle - cv::Point2d(0, 0.1 * tall()), {1.06 * wide(), 0.98 * tall()},
                    look_.hair, 0.85, 208, 332);
    PaintSidesOfHair();
  }

  // Towards the back of the head, more and more of it is hair.
  void PaintSidesOfHair() {
    const double low = look_.hair_style == HairStyle::kLong ? 0.95 : -0.05;
    const double front = look_.hair_style == HairStyle::kLong ? 1.15 : 1.35;
    for (const double side : {-1.0, 1.0}) {
      const double begin = side * front + head_.turn;
      if (std::abs(begin) >= kSideOfHead && side * begin > 0) {
        if (look_.hair_style != HairStyle::kLong) continue;
      }
      const cv::Point2d rim(side * 1.04 * wide(), 0);
      canvas_.Polygon({At(side * front, -0.6), At(side * front, low),
                       head_.middle + rim + cv::Point2d(0, low * tall()),
                       head_.middle + rim + cv::Point2d(0, -0.35 * tall())},
                      look_.hair, 0.8);
    }
  }

  void PaintCap() {
    canvas_.Ellipse(head_.middle - cv::Point2d(0, 0.28 * tall()), {1.08 * wide(), 0.8 * tall()},
                    look_.cap, 0.9, 180, 360);
    if (Facing(0) < -0.1) return;
    const cv::Point2d peak = At(0, -0.3) + cv::Point2d(0.3 * std::sin(head_.turn) * wide(), 0);
    canvas_.Ellipse(peak, {0.85 * wide(), 0.12 * tall()}, look_.cap, 0.7);
  }

  void PaintGlasses() {
    const double thick = 0.06 * wide();
    for (const double eye : {-0.44, 0.44}) {
      const double facing = Facing(eye);
      if (facing < 0.12) continue;
      canvas_.Ring(At(eye, -0.08), {0.3 * facing * wide(), 0.16 * tall()}, thick, kFrame);
      const double ear = eye > 0 ? 1.5 : -1.5;
      canvas_.Line({At(eye * 1.75, -0.1), At(ear, -0.04)}, thick, kFrame);
    }
    if (Facing(0) > 0.12) canvas_.Line({At(-0.14, -0.1), At(0.14, -0.1)}, thick, kFrame);
  }

  const PersonLook& look_;
  const HeadPlace& head_;
  Canvas& canvas_;
};

}  // namespace

void PaintHead(const PersonLook& look, const HeadPlace& head, Canvas& canvas) {
  HeadPainter(look, head, canvas).Paint();
}

void PaintHairBehind(const PersonLook& look, const HeadPlace& head, Canvas& canvas) {
  if (look.hair_style != HairStyle::kLong) return;
  canvas.Ellipse(head.middle + cv::Point2d(0, 0.4 * head.tall), {1.15 * head.wide, 1.5 * head.tall},
                 look.hair, 0.7);
}

}  // namespace coppice::robot::simulation
