#include "robot_app/simulation/appearance/person_picture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>

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
constexpr double kHeadMiddle = 0.925;
constexpr double kHeadTall = 0.075;  // half
constexpr double kHeadWide = 0.052;
constexpr double kHeadLong = 0.063;
constexpr double kHipAside = 0.05;
constexpr double kShoulderAside = 0.115;
constexpr double kLegSwing = 0.42;  // rad
constexpr double kArmSwing = 0.38;
constexpr double kKneeBend = 0.6;
constexpr double kElbowBend = 0.3;

constexpr int kSubpixel = 4;      // bits
constexpr int kDrawnTwice = 700;  // pixels; a taller one needs no finer drawing

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
constexpr Colour kMask{150, 190, 214};

cv::Scalar Opaque(const Colour& colour, double light = 1) {
  const auto channel = [&](int i) { return std::clamp(colour[i] * light, 0.0, 255.0); };
  return {channel(0), channel(1), channel(2), 255};
}

class Painter {
 public:
  Painter(const PersonLook& look, const PersonView& view, int pixels_tall)
      : look_(look),
        view_(view),
        scale_(pixels_tall),
        sheet_(static_cast<int>(std::lround(1.02 * pixels_tall)),
               2 * static_cast<int>(std::lround(kPersonSide * pixels_tall)), CV_8UC4,
               cv::Scalar::all(0)) {}

  // What is farther is painted first.
  cv::Mat Paint() {
    AddLeg(+1);
    AddLeg(-1);
    AddArm(+1);
    AddArm(-1);
    Add({0, 0, 0.65}, [this] { PaintTrunk(); });
    if (look_.has_long_hair) Add({-0.03, 0, kHeadMiddle}, [this] { PaintLongHair(); });
    Add({0.02, 0, kHeadMiddle}, [this] { PaintHead(); });
    std::stable_sort(parts_.begin(), parts_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [nearness, paint] : parts_) paint();
    return sheet_;
  }

 private:
  void Add(const Point& middle, std::function<void()> paint) {
    parts_.emplace_back(Nearness(middle), std::move(paint));
  }

  Point TowardsCamera() const { return {std::cos(view_.turn), -std::sin(view_.turn), 0}; }
  double Nearness(const Point& p) const { return p.dot(TowardsCamera()); }
  cv::Point2d OnSheet(const Point& p) const {
    const double right = p[0] * std::sin(view_.turn) + p[1] * std::cos(view_.turn);
    return {sheet_.cols / 2.0 + right * scale_, sheet_.rows - p[2] * scale_};
  }
  static cv::Point Fine(const cv::Point2d& p) {
    return {static_cast<int>(std::lround(p.x * (1 << kSubpixel))),
            static_cast<int>(std::lround(p.y * (1 << kSubpixel)))};
  }

  void Circle(const cv::Point2d& middle, double radius, const cv::Scalar& colour) {
    cv::circle(sheet_, Fine(middle), static_cast<int>(std::lround(radius * (1 << kSubpixel))),
               colour, cv::FILLED, cv::LINE_8, kSubpixel);
  }
  void Ellipse(const cv::Point2d& middle, cv::Size2d half, const cv::Scalar& colour,
               double from = 0, double to = 360) {
    const cv::Point size = Fine({half.width, half.height});
    cv::ellipse(sheet_, Fine(middle), {size.x, size.y}, 0, from, to, colour, cv::FILLED, cv::LINE_8,
                kSubpixel);
  }
  void Polygon(const std::vector<cv::Point2d>& points, const cv::Scalar& colour) {
    std::vector<cv::Point> fine;
    for (const cv::Point2d& p : points) fine.push_back(Fine(p));
    cv::fillPoly(sheet_, std::vector<std::vector<cv::Point>>{fine}, colour, cv::LINE_8, kSubpixel);
  }

  // A limb that grows thinner, round at its ends.
  void Taper(const cv::Point2d& a, const cv::Point2d& b, double at_a, double at_b,
             const cv::Scalar& colour) {
    const cv::Point2d along = b - a;
    const double length = std::max(std::hypot(along.x, along.y), 1e-6);
    const cv::Point2d across(-along.y / length, along.x / length);
    Circle(a, at_a, colour);
    Circle(b, at_b, colour);
    Polygon({a + across * at_a, b + across * at_b, b - across * at_b, a - across * at_a}, colour);
  }

  // Light comes from above and from the left.
  void Limb(const Point& from, const Point& to, double at_from, double at_to,
            const Colour& colour) {
    const cv::Point2d a = OnSheet(from);
    const cv::Point2d b = OnSheet(to);
    const double f = at_from * look_.build * scale_;
    const double t = at_to * look_.build * scale_;
    Taper(a, b, f, t, Opaque(colour, 0.72));
    Taper(a - cv::Point2d(0.2 * f, 0), b - cv::Point2d(0.2 * t, 0), 0.75 * f, 0.75 * t,
          Opaque(colour, 0.92));
    Taper(a - cv::Point2d(0.35 * f, 0), b - cv::Point2d(0.35 * t, 0), 0.35 * f, 0.35 * t,
          Opaque(colour, 1.06));
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
      Circle(OnSheet(hand), 0.021 * scale_, Opaque(look_.skin, 0.9));
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
      Polygon(points, Opaque(colour, light));
    }
  }

  void PaintLongHair() {
    const cv::Point2d middle = OnSheet({-0.03, 0, kHeadMiddle - 0.03});
    Ellipse(middle, {1.2 * kHeadWide * scale_, 1.5 * kHeadTall * scale_}, Opaque(look_.hair, 0.7));
  }

  void PaintHead() {
    const double side = std::abs(std::sin(view_.turn));
    const double wide = std::hypot(kHeadWide * std::cos(view_.turn), kHeadLong * side) * scale_;
    const cv::Point2d middle = OnSheet({0.01, 0, kHeadMiddle});
    const double tall = kHeadTall * scale_;
    Ellipse(middle, {wide, tall}, Opaque(look_.skin, 0.75));
    Ellipse(middle - cv::Point2d(0.12 * wide, 0), {0.84 * wide, 0.95 * tall}, Opaque(look_.skin));
    if (std::cos(view_.turn) > 0) PaintFace(middle, wide, tall);
    PaintHair(middle, wide, tall);
  }

  // Towards the back of the head, more and more of it is hair.
  void PaintHair(const cv::Point2d& middle, double wide, double tall) {
    const double facing = std::cos(view_.turn);
    if (facing < -0.2) {
      Ellipse(middle - cv::Point2d(0, 0.08 * tall), {1.04 * wide, 0.96 * tall},
              Opaque(look_.hair, 0.85));
      return;
    }
    Ellipse(middle - cv::Point2d(0, 0.1 * tall), {1.06 * wide, 0.98 * tall},
            Opaque(look_.hair, 0.85), 195, 345);
    if (facing > 0.85) return;
    const double back = std::sin(view_.turn) > 0 ? -1 : 1;  // where it is on the sheet
    Ellipse(middle + cv::Point2d(back * 0.55 * wide, -0.1 * tall), {0.5 * wide, 0.85 * tall},
            Opaque(look_.hair, 0.8));
  }

  void PaintFace(const cv::Point2d& middle, double wide, double tall) {
    const double shift = std::sin(view_.turn) * 0.8 * wide;
    const double narrow = std::cos(view_.turn);
    const auto at = [&](double right, double down) {
      return middle + cv::Point2d(shift + right * narrow * wide, down * tall);
    };
    for (const double eye : {-0.42, 0.42}) {
      Ellipse(at(eye, -0.08), {0.2 * narrow * wide, 0.1 * tall}, Opaque({235, 232, 228}));
      Ellipse(at(eye, -0.08), {0.1 * narrow * wide, 0.1 * tall}, Opaque({40, 30, 26}));
      Ellipse(at(eye, -0.24), {0.26 * narrow * wide, 0.05 * tall}, Opaque(look_.hair, 0.8));
    }
    if (look_.wears_mask) {
      Polygon(
          {at(-0.95, 0.1), at(0, -0.02), at(0.95, 0.1), at(0.7, 0.7), at(0, 0.92), at(-0.7, 0.7)},
          Opaque(kMask));
      return;
    }
    Ellipse(at(0.05, 0.24), {0.14 * narrow * wide, 0.1 * tall}, Opaque(look_.skin, 0.75));
    Ellipse(at(0, 0.52), {0.34 * narrow * wide, 0.07 * tall}, Opaque({150, 70, 66}));
  }

  const PersonLook& look_;
  const PersonView& view_;
  const double scale_;
  cv::Mat sheet_;
  std::vector<std::pair<double, std::function<void()>>> parts_;  // by nearness to the camera
};

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
  look.has_long_hair = random() % 3 == 0;
  look.has_long_sleeves = random() % 3 != 0;
  return look;
}

// Drawn twice as large and then reduced, so that its edges are smooth.
PersonPicture DrawPerson(const PersonLook& look, const PersonView& view, int pixels_tall) {
  const int fineness = pixels_tall > kDrawnTwice ? 1 : 2;
  cv::Mat sheet = Painter(look, view, fineness * pixels_tall).Paint();
  if (fineness > 1) cv::resize(sheet, sheet, sheet.size() / fineness, 0, 0, cv::INTER_AREA);
  return {sheet.cols, sheet.rows, pixels_tall, {sheet.datastart, sheet.dataend}};
}

}  // namespace coppice::robot::simulation
