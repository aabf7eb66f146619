#include "robot_app/simulation/camera.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kFarthest = 60;  // m
constexpr double kTile = 1;       // m
constexpr double kHead = 0.25;    // m
constexpr double kHeadRadius = 0.12;

constexpr Colour kWall{205, 203, 190};
constexpr Colour kDoor{150, 104, 62};
constexpr Colour kBoxOfPlace{214, 142, 40};
constexpr Colour kFloor{118, 122, 128};
constexpr Colour kCeiling{226, 228, 230};
constexpr Colour kSkin{222, 178, 148};
constexpr std::array<Colour, 5> kFurniture = {
    {{128, 92, 60}, {88, 112, 140}, {104, 128, 96}, {150, 118, 84}, {110, 100, 120}}};
constexpr std::array<Colour, 4> kClothes = {
    {{178, 48, 44}, {44, 84, 168}, {46, 128, 74}, {140, 60, 140}}};

Colour Shaded(const Colour& colour, double light) {
  Colour shaded;
  for (std::size_t i = 0; i < 3; ++i) {
    shaded[i] = static_cast<std::uint8_t>(std::clamp(colour[i] * light, 0.0, 255.0));
  }
  return shaded;
}

double Fog(double range) { return 0.45 + 0.55 / (1 + range * range / 150); }

// Neighbouring tiles differ, so that motion is seen.
double TileLight(Vec2 point) {
  const auto parity = static_cast<long>(std::floor(point.x / kTile)) +
                      static_cast<long>(std::floor(point.y / kTile));
  return parity % 2 == 0 ? 1.0 : 0.9;
}

Colour ColourOf(const Panel& panel) {
  switch (panel.material) {
    case Material::kWall:
      return kWall;
    case Material::kDoor:
      return kDoor;
    case Material::kFurniture:
      return kFurniture[static_cast<std::size_t>(panel.roof) % kFurniture.size()];
    case Material::kCardboard:
      return kBoxOfPlace;
  }
  return {};
}

// One part of a column.
struct Slice {
  double range = 0;  // along the optical axis [m]
  double bottom = 0;
  double top = 0;
  Colour colour{};
};

class Renderer {
 public:
  Renderer(const World& world, const CameraOptions& options)
      : world_(world),
        options_(options),
        camera_(Compose(world.robot(), options.mounting)),
        focal_(options.width / 2.0 / std::tan(options.field_of_view / 2)) {
    picture_.width = options.width;
    picture_.height = options.height;
    picture_.rgb.resize(static_cast<std::size_t>(3) * options.width * options.height);
  }

  Picture Render() {
    for (int column = 0; column < options_.width; ++column) {
      const double tangent = (options_.width / 2.0 - column - 0.5) / focal_;
      const double angle = std::atan(tangent);
      const Vec2 direction = Direction(camera_.yaw + angle);
      DrawBackground(column, direction, std::cos(angle));
      DrawSlices(column, SlicesOf(direction, std::cos(angle)));
    }
    return std::move(picture_);
  }

 private:
  std::vector<Slice> SlicesOf(Vec2 direction, double cosine) const {
    std::vector<Slice> slices;
    const Vec2 origin = camera_.position();
    for (const Panel& panel : world_.still().panels) {
      const double range = CastAtSegment(panel.edge, origin, direction, kFarthest);
      if (range >= kFarthest) continue;
      const Vec2 along = panel.edge.b - panel.edge.a;
      const double facing = std::abs(Cross(direction, along)) / std::max(Length(along), 1e-9);
      const double light =
          (0.6 + 0.4 * facing) * Fog(range) * TileLight(origin + direction * range);
      slices.push_back({range * cosine, 0, panel.top, Shaded(ColourOf(panel), light)});
    }
    for (std::size_t i = 0; i < world_.people().size(); ++i) {
      AddPerson(world_.people()[i], world_.floor().people[i].height, kClothes[i % kClothes.size()],
                direction, cosine, slices);
    }
    std::sort(slices.begin(), slices.end(),
              [](const Slice& a, const Slice& b) { return a.range > b.range; });
    return slices;
  }

  void AddPerson(const Disc& body, double height, const Colour& clothes, Vec2 direction,
                 double cosine, std::vector<Slice>& slices) const {
    for (const bool is_head : {false, true}) {
      const Disc disc{body.center, is_head ? kHeadRadius : body.radius};
      const double range = CastAtDisc(disc, camera_.position(), direction, kFarthest);
      if (range >= kFarthest) continue;
      const Vec2 hit = camera_.position() + direction * range - disc.center;
      const double light = (0.65 - 0.35 * Dot(hit, direction) / disc.radius) * Fog(range);
      slices.push_back({range * cosine, is_head ? height - kHead : 0,
                        is_head ? height : height - kHead,
                        Shaded(is_head ? kSkin : clothes, light)});
    }
  }

  void DrawBackground(int column, Vec2 direction, double cosine) {
    for (int row = 0; row < options_.height; ++row) {
      const double down = (row + 0.5 - options_.height / 2.0) / focal_;
      if (down <= 0) {
        Set(column, row, Shaded(kCeiling, 1 + 0.3 * down));
        continue;
      }
      const double range = std::min(options_.lens_height / down / cosine, kFarthest);
      const Vec2 point = camera_.position() + direction * range;
      Set(column, row, Shaded(kFloor, Fog(range) * TileLight(point)));
    }
  }

  void DrawSlices(int column, const std::vector<Slice>& slices) {
    for (const Slice& slice : slices) {
      const double range = std::max(slice.range, 0.01);
      const double middle = options_.height / 2.0;
      const double first = middle - focal_ * (slice.top - options_.lens_height) / range;
      const double last = middle - focal_ * (slice.bottom - options_.lens_height) / range;
      const int end = static_cast<int>(std::clamp(last, 0.0, double(options_.height)));
      for (int row = static_cast<int>(std::clamp(first, 0.0, double(options_.height))); row < end;
           ++row) {
        Set(column, row, slice.colour);
      }
    }
  }

  void Set(int column, int row, const Colour& colour) {
    const std::size_t i = 3 * (static_cast<std::size_t>(row) * options_.width + column);
    std::copy(colour.begin(), colour.end(), picture_.rgb.begin() + static_cast<std::ptrdiff_t>(i));
  }

  const World& world_;
  const CameraOptions& options_;
  const Pose2 camera_;
  const double focal_;  // [pixels]
  Picture picture_;
};

}  // namespace

Picture RenderPicture(const World& world, const CameraOptions& options) {
  return Renderer(world, options).Render();
}

}  // namespace coppice::robot::simulation
