#include "robot_app/training/labelled_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "robot_app/simulation/camera/rgbd_camera.h"
#include "robot_app/training/draw.h"
#include "robot_app/training/random_hall.h"

namespace coppice::robot::training {
namespace {

using perception::Box;
using perception::Sighting;
using perception::SightingKind;
using simulation::kPi;
using simulation::Pose2;
using simulation::SeenPerson;
using simulation::Vec2;

constexpr double kNearest = 0.8;  // m
constexpr double kFarthest = 4;
constexpr double kMostTurned = kPi / 3;
constexpr double kHalfView = 0.42;  // rad
constexpr double kApart = 0.6;      // m, of two people
constexpr double kInPicture = 0.8;  // at least so much of a face is inside
constexpr double kSeen = 0.7;       // and not hidden
constexpr double kSameDepth = 0.3;  // m
constexpr double kHairline = 0.8;   // of half the head's height above its middle
constexpr int kTries = 40;

struct Photographer {
  Site site;
  Pose2 lens;
  double height = 1.35;  // of the lens [m]
};

Photographer PlaceLens(std::mt19937_64& random) {
  Photographer from;
  for (int i = 0; i < kTries; ++i) {
    from.site = MakeRandomHall(random);
    const Vec2 half = from.site.area.size * 0.5;
    from.lens = {Draw(random, -half.x, half.x), Draw(random, -half.y, half.y),
                 Draw(random, -kPi, kPi)};
    const Vec2 ahead = from.lens.position() + simulation::Direction(from.lens.yaw) * 2.0;
    if (IsFree(from.site, from.lens.position(), 0.5) && IsFree(from.site, ahead, 0.4)) break;
  }
  from.height = Draw(random, 1.15, 1.5);
  return from;
}

simulation::PersonLook LookOf(std::mt19937_64& random) {
  simulation::PersonLook look = simulation::RandomPersonLook(random());
  look.wears_mask = random() % 2 == 0;
  look.has_mask_at_chin = !look.wears_mask && random() % 8 == 0;
  return look;
}

// Somebody at a distance in some direction of the lens, who looks past it by `turned`.
void Add(const Photographer& from, double distance, double turned, std::mt19937_64& random,
         std::vector<SeenPerson>& people) {
  const double bearing = from.lens.yaw + Draw(random, -kHalfView, kHalfView);
  const Vec2 at = from.lens.position() + simulation::Direction(bearing) * distance;
  const auto is_near = [&](const SeenPerson& other) {
    return simulation::Length(other.stance.position - at) < kApart;
  };
  if (!IsFree(from.site, at, 0.25) || std::any_of(people.begin(), people.end(), is_near)) return;
  SeenPerson person;
  person.look = LookOf(random);
  person.stance.position = at;
  person.stance.heading = bearing + kPi + turned;
  person.stance.walks = random() % 2 == 0;
  person.stance.walked = Draw(random, 0, 10);
  person.stance.height = Draw(random, 1.45, 1.95);
  people.push_back(person);
}

std::vector<SeenPerson> Gather(const Photographer& from, std::mt19937_64& random) {
  std::vector<SeenPerson> people;
  const std::size_t wanted = 1 + random() % 3;
  for (int i = 0; i < kTries && people.size() < wanted; ++i) {
    Add(from, Draw(random, kNearest, kFarthest), Draw(random, -kMostTurned, kMostTurned), random,
        people);
  }
  for (std::uint64_t i = random() % 3; i > 0; --i) {
    Add(from, Draw(random, 1.5, 8), Draw(random, -kPi, kPi), random, people);
  }
  return people;
}

// Of the depths measured in the inner half of a box, those that are about `depth`.
double SeenShare(const DepthPicture& picture, const Box& box, double depth) {
  int measured = 0, same = 0;
  for (int i = 0; i < 49; ++i) {
    const int line = i / 7;
    const int column = static_cast<int>(box.x + box.width * (0.25 + 0.5 * (i % 7) / 6.0));
    const int row = static_cast<int>(box.y + box.height * (0.25 + 0.5 * line / 6.0));
    if (column < 0 || row < 0 || column >= picture.width || row >= picture.height) continue;
    const int millimetres = picture.at(column, row);
    measured += millimetres > 0 ? 1 : 0;
    same += millimetres > 0 && std::abs(millimetres / 1000.0 - depth) < kSameDepth ? 1 : 0;
  }
  return measured > 0 ? static_cast<double>(same) / measured : 0;
}

double ShareInside(const Box& box, const Picture& picture) {
  const double wide = std::min(box.right(), double(picture.width)) - std::max(box.x, 0.0);
  const double tall = std::min(box.bottom(), double(picture.height)) - std::max(box.y, 0.0);
  return std::max(0.0, wide) * std::max(0.0, tall) / box.area();
}

Box FaceOf(const SeenPerson& person, Vec2 place, double turned, double lens_height,
           const Lens& lens) {
  const double scale = lens.fy * person.stance.height / place.x;
  const double wide = scale * std::hypot(simulation::kHeadHalfWide * std::cos(turned),
                                         simulation::kHeadHalfLong * std::sin(turned));
  const double tall = scale * simulation::kHeadHalfTall;
  const double x = lens.cx - lens.fx * place.y / place.x;
  const double y = lens.cy + lens.fy * lens_height / place.x - scale * simulation::kHeadMiddle;
  return {x - wide, y - kHairline * tall, 2 * wide, (1 + kHairline) * tall};
}

// Of whoever looks at the lens or not much past it.
void Label(const Photographer& from, const SeenPerson& person, const Lens& lens,
           LabelledPicture& picture) {
  const Vec2 to_lens = from.lens.position() - person.stance.position;
  const double turned =
      std::abs(simulation::NormalAngle(person.stance.heading - std::atan2(to_lens.y, to_lens.x)));
  const Vec2 place = simulation::Rotated(to_lens * -1.0, -from.lens.yaw);
  if (turned > 1.7 || place.x < 0.3) return;
  Sighting face;
  face.kind = person.look.wears_mask ? SightingKind::kFaceWithMask : SightingKind::kFaceWithoutMask;
  face.box = FaceOf(person, place, turned, from.height, lens);
  const bool counts = turned <= kMostTurned + 0.01 && simulation::Length(place) <= kFarthest &&
                      ShareInside(face.box, picture.colour) >= kInPicture &&
                      SeenShare(picture.depth, face.box, place.x) >= kSeen;
  face.confidence = counts ? 1 : 0;
  if (ShareInside(face.box, picture.colour) > 0) picture.faces.push_back(face);
}

// Light, lens and sensor are not always good.
void Expose(Picture& picture, std::mt19937_64& random) {
  cv::Mat pixels(picture.height, picture.width, CV_8UC3, picture.rgb.data());
  const double blur = Draw(random, 0, 1.3);
  if (blur > 0.4) cv::GaussianBlur(pixels, pixels, {}, blur);
  const double bright = Draw(random, 0.45, 1.25);
  const double warm = Draw(random, -0.12, 0.12);
  const double contrast = Draw(random, 0.75, 1.15);
  std::array<std::array<std::uint8_t, 256>, 3> tables{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double gain = bright * (1 + warm * (1 - static_cast<double>(k)));
    for (int value = 0; value < 256; ++value) {
      const double lit = 128 * gain + (value - 128) * contrast * gain;
      tables[k][static_cast<std::size_t>(value)] =
          static_cast<std::uint8_t>(std::clamp(lit, 0.0, 255.0));
    }
  }
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = tables[i % 3][picture.rgb[i]];
  }
}

}  // namespace

LabelledPicture MakeLabelledPicture(std::mt19937_64& random) {
  const Photographer from = PlaceLens(random);
  const std::vector<SeenPerson> people = Gather(from, random);
  const simulation::Scene scene(from.site.still);
  simulation::RgbdCamera camera({}, random());
  simulation::RgbdPicture taken = camera.Take(scene, people, from.lens, from.height);
  LabelledPicture picture{
      std::move(taken.colour), std::move(taken.depth), camera.options().lens.fx, {}};
  for (const SeenPerson& person : people) Label(from, person, camera.options().lens, picture);
  Expose(picture.colour, random);
  return picture;
}

}  // namespace coppice::robot::training
