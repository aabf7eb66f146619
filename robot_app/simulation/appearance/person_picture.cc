#include "robot_app/simulation/appearance/person_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <utility>
#include <vector>

#include "robot_app/simulation/appearance/canvas.h"
#include "robot_app/simulation/appearance/head_picture.h"

namespace coppice::robot::simulation {
namespace {

// A point of the body: x forward, y left, z up, as shares of the body's height, on the floor
// between the feet.
using Point = cv::Vec3d;

// Shares of the body's height (Drillis and Contini 1966, rounded).
constexpr double kAnkle = 0.04;
constexpr double kThigh = 0.235;
constexpr double kShin = 0.235;
constexpr double kHip = kAnkle + kShin + kThigh;
constexpr double kShoulder = 0.805;
constexpr double kUpperArm = 0.165;
constexpr double kForearm = 0.19;
constexpr double kHipAside = 0.05;
constexpr double kShoulderAside = 0.115;
constexpr double kLegSwing = 0.42;  // rad
constexpr double kArmSwing = 0.38;
constexpr double kKneeBend = 0.6;
constexpr double kElbowBend = 0.3;

constexpr int kDrawnTwice = 700;  // pixels; a taller one needs no finer drawing

class Painter {
 public:
  Painter(const PersonLook& look, const PersonView& view, int pixels_tall)
      : look_(look),
        view_(view),
        scale_(pixels_tall),
        canvas_(2 * static_cast<int>(std::lround(kPersonSide * pixels_tall)),
                static_cast<int>(std::lround(1.02 * pixels_tall))) {}

  // What is farther is painted first.
  cv::Mat Paint() {
    AddLeg(+1);
    AddLeg(-1);
    AddArm(+1);
    AddArm(-1);
    Add({0, 0, 0.65}, [this] { PaintTrunk(); });
    Add({-0.03, 0, kHeadMiddle}, [this] { PaintHairBehind(look_, HeadAt(-0.02), canvas_); });
    Add({0.02, 0, kHeadMiddle}, [this] { PaintHead(look_, HeadAt(0.01), canvas_); });
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [nearness, paint] : parts_) paint();
    return canvas_.sheet();
  }

 private:
  void Add(const Point& middle, std::function<void()> paint) {
    parts_.emplace_back(Nearness(middle), std::move(paint));
  }

  Point TowardsCamera() const { return {std::cos(view_.turn), -std::sin(view_.turn), 0}; }
  double Nearness(const Point& p) const { return p.dot(TowardsCamera()); }
  cv::Point2d OnSheet(const Point& p) const {
    const double right = p[0] * std::sin(view_.turn) + p[1] * std::cos(view_.turn);
    return {canvas_.sheet().cols / 2.0 + right * scale_, canvas_.sheet().rows - p[2] * scale_};
  }

  HeadPlace HeadAt(double forward) const {
    const double wide =
        std::hypot(kHeadHalfWide * std::cos(view_.turn), kHeadHalfLong * std::sin(view_.turn));
    return {OnSheet({forward, 0, kHeadMiddle}), wide * scale_, kHeadHalfTall * scale_, view_.turn};
  }

  // Light comes from above and from the left.
  void Limb(const Point& from, const Point& to, double at_from, double at_to,
            const Colour& colour) {
    const cv::Point2d a = OnSheet(from);
    const cv::Point2d b = OnSheet(to);
    const double f = at_from * look_.build * scale_;
    const double t = at_to * look_.build * scale_;
    canvas_.Taper(a, b, f, t, colour, 0.72);
    canvas_.Taper(a - cv::Point2d(0.2 * f, 0), b - cv::Point2d(0.2 * t, 0), 0.75 * f, 0.75 * t,
                  colour, 0.92);
    canvas_.Taper(a - cv::Point2d(0.35 * f, 0), b - cv::Point2d(0.35 * t, 0), 0.35 * f, 0.35 * t,
                  colour, 1.06);
  }

  // `side` is +1 for the left one.
  void AddLeg(int side) {
    const double phase = view_.step + (side > 0 ? 0 : CV_PI);
    const double swing = view_.walks ? kLegSwing * std::sin(phase) : 0;
    const double bend = view_.walks ? kKneeBend * std::max(0.0, std::cos(phase)) : 0;
    const Point hip(0, side * kHipAside, kHip);
    const Point knee = hip + kThigh * Point(std::sin(swing), 0, -std::cos(swing));
    const Point ankle = knee + kShin * Point(std::sin(swing - bend), 0, -std::cos(swing - bend));
    // Behind all else, whichever way it swings: the trunk covers the hips of both legs.
    Add((hip + ankle) * 0.5 - TowardsCamera(), [=] {
      Limb(ankle - Point(0.02, 0, 0.012), ankle + Point(0.075, 0, -0.022), 0.02, 0.016,
           look_.shoes);
      Limb(knee, ankle, 0.038, 0.024, look_.trousers);
      Limb(hip, knee, 0.058, 0.04, look_.trousers);
    });
  }

  void AddArm(int side) {
    const double phase = view_.step + (side > 0 ? CV_PI : 0);
    const double swing = view_.walks ? kArmSwing * std::sin(phase) : 0;
    const double bend = view_.walks ? kElbowBend : 0.12;
    const Point shoulder(0, side * kShoulderAside * look_.build, kShoulder - 0.015);
    const Point elbow =
        shoulder + kUpperArm * Point(std::sin(swing), side * 0.13, -std::cos(swing));
    const Point hand =
        elbow + kForearm * Point(std::sin(swing + bend), side * 0.04, -std::cos(swing + bend));
    Add((shoulder + hand) * 0.5 + Point(0, side * 0.03, 0), [=] {
      Limb(elbow, hand, 0.025, 0.017, look_.has_long_sleeves ? look_.top : look_.skin);
      canvas_.Circle(OnSheet(hand), 0.021 * scale_, look_.skin, 0.9);
      Limb(shoulder, elbow, 0.034, 0.027, look_.top);
    });
  }

  void PaintTrunk() {
    const double wide =
        look_.build * std::hypot(0.118 * std::cos(view_.turn), 0.068 * std::sin(view_.turn));
    Limb({0, 0, 0.84}, {0.008, 0, 0.875}, 0.026, 0.026, look_.skin);
    PaintCloth(wide, look_.trousers, {{0.54, 0.86}, {0.5, 0.9}, {0.455, 0.86}});
    PaintCloth(wide, look_.top,
               {{0.85, 0.28},
                {0.835, 0.62},
                {0.815, 0.92},
                {0.78, 1.0},
                {0.7, 0.93},
                {0.62, 0.86},
                {0.56, 0.88},
                {0.5, 0.95}});
  }

  // A symmetrical outline: pairs of height and share of the width.
  void PaintCloth(double wide, const Colour& colour,
                  const std::vector<std::pair<double, double>>& outline) {
    const std::array<std::array<double, 3>, 3> lights = {
        {{1, 0, 0.74}, {0.8, -0.16, 0.92}, {0.42, -0.3, 1.05}}};
    for (const auto& [share, aside, light] : lights) {
      std::vector<cv::Point2d> points;
      for (const auto& [height, width] : outline) {
        points.push_back(OnSheet({0, 0, height}) +
                         cv::Point2d((aside - share * width) * wide * scale_, 0));
      }
      for (auto i = outline.rbegin(); i != outline.rend(); ++i) {
        points.push_back(OnSheet({0, 0, i->first}) +
                         cv::Point2d((aside + share * i->second) * wide * scale_, 0));
      }
      canvas_.Polygon(points, colour, light);
    }
  }

  const PersonLook& look_;
  const PersonView& view_;
  const double scale_;
  Canvas canvas_;
  std::vector<std::pair<double, std::function<void()>>> parts_;  // by nearness to the camera
};

}  // namespace

// Drawn twice as large and then reduced, so that its edges are smooth.
PersonPicture DrawPerson(const PersonLook& look, const PersonView& view, int pixels_tall) {
  const int fineness = pixels_tall > kDrawnTwice ? 1 : 2;
  cv::Mat sheet = Painter(look, view, fineness * pixels_tall).Paint();
  if (fineness > 1) cv::resize(sheet, sheet, sheet.size() / fineness, 0, 0, cv::INTER_AREA);
  return {sheet.cols, sheet.rows, pixels_tall, {sheet.datastart, sheet.dataend}};
}

}  // namespace coppice::robot::simulation
