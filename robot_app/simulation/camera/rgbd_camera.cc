#include "robot_app/simulation/camera/rgbd_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robot_app/simulation/camera/person_relief.h"
#include "robot_app/simulation/camera/surfaces.h"

namespace coppice::robot::simulation {
namespace {

constexpr double kFarthest = 60;      // m
constexpr double kNearest = 0.05;     // m
constexpr double kEdge = 0.08;        // share: a larger step of depth is an edge
constexpr std::uint8_t kCovered = 9;  // of 255
constexpr int kBlock = 32;            // columns
constexpr int kMostTall = 1400;       // pixels
constexpr int kLeastTall = 8;
constexpr float kNothing = std::numeric_limits<float>::infinity();

double Fog(double range) { return 0.5 + 0.5 / (1 + range * range / 200); }

// A standard normal number for a lot: the sum of its upper four bytes.
float Bell(std::uint64_t lot) {
  int sum = 0;
  for (int i = 4; i < 8; ++i) sum += static_cast<int>(lot >> (8 * i) & 0xff);
  return static_cast<float>(sum - 510) / 148.0F;
}

// A stretch of a ray over a panel or, between two sides of a box, over its roof.
struct Meeting {
  double range = 0;  // on the floor [m]
  std::uint32_t panel = 0;
};

// What a row of the picture shows of the floor or the ceiling.
struct Ground {
  double depth = 0;  // [m]
  double light = 1;
};

class Drawing {
 public:
  Drawing(const RgbdOptions& options, const Scene& scene, const Pose2& pose, double height)
      : options_(options),
        scene_(scene),
        pose_(pose),
        lens_height_(height),
        colour_(static_cast<std::size_t>(options.width) * options.height),
        depth_(colour_.size(), kNothing) {
    const double light = std::clamp(scene.still().light, 0.001, 1.0);
    const bool in_sun = std::isinf(scene.still().ceiling) && light >= options.sun_from;
    max_depth_ = in_sun ? options.max_depth_in_sun : options.max_depth;
    gain_ = static_cast<int>(std::lround(std::min(options.most_gain, 1 / light)));
    exposure_ = static_cast<int>(std::lround(256 * std::min(1.0, light * gain_)));
    for (int row = 0; row < options.height; ++row) {
      const double down = Down(row);
      const double drop = down > 0 ? height : height - scene.still().ceiling;
      const double depth = down != 0 ? std::min(drop / down, kFarthest) : kFarthest;
      ground_.push_back({depth, Fog(depth)});
    }
  }

  void DrawStill() {
    for (int column = 0; column < options_.width; ++column) DrawColumn(column);
  }

  // The nearest at last.
  void DrawPeople(const std::vector<SeenPerson>& people) {
    std::vector<std::pair<Vec2, const SeenPerson*>> seen;  // with the place in the camera's frame
    for (const SeenPerson& person : people) {
      const Vec2 place = Rotated(person.stance.position - pose_.position(), -pose_.yaw);
      if (place.x > options_.min_depth && place.x < kFarthest) seen.push_back({place, &person});
    }
    std::sort(seen.begin(), seen.end(),
              [](const auto& a, const auto& b) { return a.first.x > b.first.x; });
    for (const auto& [place, person] : seen) DrawOne(*person, place);
  }

  // The sensors' errors, by lot from `seed`. In blocks, because what was drawn column by column is
  // written row by row.
  RgbdPicture Measure(std::uint64_t seed) const {
    RgbdPicture measured{Picture(options_.width, options_.height),
                         DepthPicture(options_.width, options_.height)};
    for (int first = 0; first < options_.width; first += kBlock) {
      const int last = std::min(first + kBlock, options_.width);
      for (int row = 0; row < options_.height; ++row) {
        for (int column = first; column < last; ++column) {
          MeasurePixel(column, row, Mixed(seed, At(column, row)), measured);
        }
      }
    }
    return measured;
  }

 private:
  const Lens& lens() const { return options_.lens; }
  std::size_t At(int column, int row) const {
    return static_cast<std::size_t>(column) * options_.height + row;
  }
  void Set(int column, int row, const Colour& colour, double depth) {
    const std::size_t i = At(column, row);
    colour_[i] = colour;
    depth_[i] = static_cast<float>(depth);
  }
  // The first row below a height at a depth, within the picture.
  int RowOf(double height, double depth) const {
    const double row = lens().cy + lens().fy * (lens_height_ - height) / depth;
    return static_cast<int>(std::ceil(std::clamp(row, 0.0, double(options_.height))));
  }
  // Tangent of the angle below the horizon.
  double Down(int row) const { return (row - lens().cy) / lens().fy; }

  void DrawColumn(int column) {
    const double angle = std::atan((lens().cx - column) / lens().fx);
    const Vec2 direction = Direction(pose_.yaw + angle);
    const double cosine = std::cos(angle);
    const std::vector<Meeting>& met = Meet(direction);
    DrawFloorAndCeiling(column, direction, cosine);
    for (auto i = met.rbegin(); i != met.rend(); ++i) {
      const Panel& panel = scene_.still().panels[i->panel];
      DrawPanel(column, panel, direction, cosine, i->range);
      // The far side of a box is hidden by its roof.
      if (panel.roof != Panel::kNoRoof) DrawRoof(column, panel, cosine, i->range);
    }
  }

  void DrawFloorAndCeiling(int column, Vec2 direction, double cosine) {
    const auto draw = [&](int first, int last, auto colour_at) {
      for (int row = first; row < last; ++row) {
        const Ground& ground = ground_[static_cast<std::size_t>(row)];
        const Vec2 point = pose_.position() + direction * (ground.depth / cosine);
        Set(column, row, Lit(colour_at(point), ground.light), ground.depth);
      }
    };
    // Behind a wall up to the ceiling there is nothing of them to be seen.
    const double ceiling = scene_.still().ceiling;
    const bool is_closed = !met_.empty() && scene_.still().panels[met_.back().panel].top >= ceiling;
    const double depth = is_closed ? met_.back().range * cosine : kFarthest;
    const int horizon = RowOf(lens_height_, depth);
    draw(0, is_closed ? RowOf(ceiling, depth) : horizon, std::isinf(ceiling) ? SkyAt : CeilingAt);
    draw(is_closed ? RowOf(0, depth) : horizon, options_.height, FloorAt);
  }

  // Nearest first, up to the first that nothing is seen over.
  const std::vector<Meeting>& Meet(Vec2 direction) {
    met_.clear();
    const RayCaster& edges = scene_.edges();
    double farthest = kFarthest;
    for (CellWalk walk(edges, pose_.position(), direction, kFarthest); walk.inside(); walk.Next()) {
      for (const std::uint32_t index : edges.items(walk.cell())) {
        const Panel& panel = scene_.still().panels[index];
        const double range = CastAtSegment(panel.edge, pose_.position(), direction, farthest);
        if (range >= farthest) continue;
        met_.push_back({range, index});
        if (panel.top >= scene_.still().ceiling) farthest = range;
      }
      if (farthest <= walk.border()) break;
    }
    const auto is_before = [](const Meeting& a, const Meeting& b) {
      return a.range != b.range ? a.range < b.range : a.panel < b.panel;
    };
    std::sort(met_.begin(), met_.end(), is_before);
    const auto is_same = [](const Meeting& a, const Meeting& b) { return a.panel == b.panel; };
    met_.erase(std::unique(met_.begin(), met_.end(), is_same), met_.end());
    while (!met_.empty() && met_.back().range > farthest) met_.pop_back();
    return met_;
  }

  void DrawPanel(int column, const Panel& panel, Vec2 direction, double cosine, double range) {
    const double depth = std::max(range * cosine, kNearest);
    const Vec2 along = panel.edge.b - panel.edge.a;
    const double length = std::max(Length(along), 1e-9);
    const Vec2 point = pose_.position() + direction * range;
    const PanelLine line(panel, Length(point - panel.edge.a));
    const double facing = std::abs(Cross(direction, along)) / length;
    const double light = (0.62 + 0.38 * facing) * Fog(depth);
    const int last = RowOf(0, depth);
    for (int row = RowOf(panel.top, depth); row < last; ++row) {
      Set(column, row, Lit(line.At(lens_height_ - Down(row) * depth), light), depth);
    }
  }

  // From where the ray comes over the box to this side of it, if the lens looks down on it.
  void DrawRoof(int column, const Panel& panel, double cosine, double range) {
    const Roof& roof = scene_.still().roofs[static_cast<std::size_t>(panel.roof)];
    if (roof.height >= lens_height_) return;
    double nearest = range;
    for (const Meeting& other : met_) {
      if (scene_.still().panels[other.panel].roof == panel.roof) {
        nearest = std::min(nearest, other.range);
      }
    }
    if (Distance(pose_.position(), roof.shape) <= 0) nearest = 0;
    if (nearest >= range) return;
    const Colour colour = RoofAt(panel);
    const int last = RowOf(roof.height, std::max(nearest * cosine, kNearest));
    for (int row = RowOf(roof.height, range * cosine); row < last; ++row) {
      const double depth = (lens_height_ - roof.height) / std::max(Down(row), 1e-6);
      Set(column, row, Lit(colour, Fog(depth)), depth);
    }
  }

  void DrawOne(const SeenPerson& person, Vec2 place) {
    const double pixels_tall = lens().fy * person.stance.height / place.x;
    const double middle = lens().cx - lens().fx * place.y / place.x;
    const double half = kPersonSide * pixels_tall;
    if (middle - half > options_.width || middle + half < 0) return;
    const Vec2 to_lens = pose_.position() - person.stance.position;
    PersonView view;
    view.turn = NormalAngle(person.stance.heading - std::atan2(to_lens.y, to_lens.x));
    view.walks = person.stance.walks;
    view.step = 2 * kPi * person.stance.walked / kStride;
    const int drawn = std::clamp(static_cast<int>(std::ceil(pixels_tall)), kLeastTall, kMostTall);
    PersonRelief relief(MakeFigure(person.stance), lens(), pose_, lens_height_);
    Paste(DrawPerson(person.look, view, drawn), middle, place.x, pixels_tall / drawn, relief);
  }

  // `middle` is the column of the feet; one pixel of `picture` is `zoom` pixels here.
  void Paste(const PersonPicture& picture, double middle, double depth, double zoom,
             PersonRelief& relief) {
    const double bottom = lens().cy + lens().fy * lens_height_ / depth;
    const double left = middle - zoom * picture.width / 2;
    const double top = bottom - zoom * picture.height;
    const auto within = [](double x, int most) {
      return static_cast<int>(std::clamp(std::ceil(x), 0.0, double(most)));
    };
    const double light = 1.05 * Fog(depth);
    const int last_row = within(bottom, options_.height);
    const int last_column = within(left + zoom * picture.width, options_.width);
    for (int column = within(left, options_.width); column < last_column; ++column) {
      relief.LookAlong(column);
      const int from_column = std::min(static_cast<int>((column - left) / zoom), picture.width - 1);
      for (int row = within(top, options_.height); row < last_row; ++row) {
        const int from_row = std::min(static_cast<int>((row - top) / zoom), picture.height - 1);
        const std::uint8_t* const pixel =
            &picture.rgba[4 * (static_cast<std::size_t>(from_row) * picture.width + from_column)];
        Blend(column, row, pixel, light, relief.At(row));
      }
    }
  }

  void Blend(int column, int row, const std::uint8_t* pixel, double light, double depth) {
    const std::size_t i = At(column, row);
    if (pixel[3] == 0 || depth >= depth_[i]) return;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint8_t& channel = colour_[i][k];
      const double mixed = pixel[k] * light + channel * (255 - pixel[3]) / 255.0;
      channel = static_cast<std::uint8_t>(std::min(mixed, 255.0));
    }
    if (pixel[3] > 127) depth_[i] = static_cast<float>(depth);
  }

  // Stereo finds nothing where one of its eyes looks past an edge.
  bool IsAtEdge(int column, int row) const {
    if (column < 2 || column + 2 >= options_.width) return true;
    const float here = depth_[At(column, row)];
    const auto is_step = [&](int other) {
      return std::abs(depth_[At(other, row)] - here) > kEdge * here;
    };
    return is_step(column - 2) || is_step(column + 2);
  }

  void MeasurePixel(int column, int row, std::uint64_t lot, RgbdPicture& measured) const {
    const std::size_t to = static_cast<std::size_t>(row) * options_.width + column;
    const Colour& colour = colour_[At(column, row)];
    const int choices = 2 * options_.colour_noise + 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const int byte = static_cast<int>(lot >> (8 * k) & 0xff);
      const int noise = gain_ * ((byte * choices >> 8) - options_.colour_noise);
      const int bright = colour[k] * exposure_ >> 8;
      measured.colour.rgb[3 * to + k] =
          static_cast<std::uint8_t>(std::clamp(bright + noise, 0, 255));
    }
    const float depth = depth_[At(column, row)];
    if (!(depth >= options_.min_depth && depth <= max_depth_)) return;
    if (IsAtEdge(column, row)) return;
    const float error = static_cast<float>(options_.depth_noise) * depth * depth * Bell(lot);
    measured.depth.millimetres[to] =
        static_cast<std::uint16_t>(1000 * std::max(depth + error, 0.001F) + 0.5F);
  }

  const RgbdOptions& options_;
  const Scene& scene_;
  const Pose2 pose_;
  const double lens_height_;
  double max_depth_ = 0;  // that is measured [m]
  int gain_ = 1;
  int exposure_ = 256;          // of 256: how bright the picture is
  std::vector<Ground> ground_;  // by row
  // Column by column.
  std::vector<Colour> colour_;
  std::vector<float> depth_;  // along the optical axis [m]
  std::vector<Meeting> met_;
};

// Rows that were damaged on the way: shifted sideways, of wrong colours, without depth.
void Damage(double share, std::uint64_t seed, RgbdPicture& picture) {
  const int width = picture.colour.width;
  for (int row = 0; row < picture.colour.height; ++row) {
    const std::uint64_t lot = Mixed(seed, static_cast<std::uint64_t>(row / 4), 7);
    if (static_cast<double>(lot % 10000) >= share * 10000) continue;
    const auto first = picture.colour.rgb.begin() + static_cast<std::ptrdiff_t>(3) * row * width;
    std::rotate(first, first + static_cast<std::ptrdiff_t>(1 + lot / 10000 % (3U * width - 1)),
                first + static_cast<std::ptrdiff_t>(3) * width);
    const auto depths =
        picture.depth.millimetres.begin() + static_cast<std::ptrdiff_t>(row) * width;
    std::fill(depths, depths + width, std::uint16_t{0});
  }
}

}  // namespace

RgbdCamera::RgbdCamera(const RgbdOptions& options, std::uint64_t seed)
    : options_(options), seed_(seed) {}

RgbdPicture RgbdCamera::Take(const Scene& scene, const std::vector<SeenPerson>& people,
                             const Pose2& pose, double height, const CameraFault& fault) {
  const std::uint64_t seed = Mixed(seed_, taken_++);
  RgbdPicture picture;
  if (fault.is_covered) {
    picture.colour = Picture(options_.width, options_.height);
    picture.depth = DepthPicture(options_.width, options_.height);
    std::fill(picture.colour.rgb.begin(), picture.colour.rgb.end(), kCovered);
  } else {
    Drawing drawing(options_, scene, pose, height);
    drawing.DrawStill();
    drawing.DrawPeople(people);
    picture = drawing.Measure(seed);
  }
  if (fault.broken > 0) Damage(fault.broken, seed, picture);
  return picture;
}

}  // namespace coppice::robot::simulation
