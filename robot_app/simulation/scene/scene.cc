#include "robot_app/simulation/scene/scene.h"

#include <utility>

namespace coppice::robot::simulation {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFloor = 0.25;  // reflectivity
constexpr double kCeiling = 0.8;

double ReflectivityOf(Material material) {
  switch (material) {
    case Material::kWall:
      return 0.7;
    case Material::kDoor:
      return 0.45;
    case Material::kFurniture:
      return 0.35;
    case Material::kCardboard:
      return 0.55;
    case Material::kPoster:
      return 0.7;
  }
  return 0;
}

std::vector<Segment> EdgesOf(const std::vector<Panel>& panels) {
  std::vector<Segment> edges;
  edges.reserve(panels.size());
  for (const Panel& panel : panels) edges.push_back(panel.edge);
  return edges;
}

void Offer(const Hit& offered, Hit& hit) {
  if (offered.range < hit.range) hit = offered;
}

double Farthest(const std::vector<Hit>& hits) {
  double farthest = 0;
  for (const Hit& hit : hits) farthest = std::max(farthest, hit.range);
  return farthest;
}

// Where a ray goes into a disc and out again, on the floor. False if it misses.
bool Cross(const Disc& disc, Vec2 origin, Vec2 direction, double& in, double& out) {
  const Vec2 to_center = disc.center - origin;
  const double along = Dot(to_center, direction);
  const double off = Dot(to_center, to_center) - along * along;
  const double half2 = disc.radius * disc.radius - off;
  if (half2 < 0) return false;
  const double half = std::sqrt(half2);
  in = std::max(along - half, 0.0);
  out = along + half;
  return out >= 0;
}

// The range at which a ray of a slope meets the pillar between `in` and `out`, at its side, its top
// or its bottom.
double CastAtPillar(const Pillar& pillar, double height, double slope, double in, double out) {
  const double z = height + slope * in;
  if (z >= pillar.bottom && z <= pillar.top) return in;
  const double face = z > pillar.top ? pillar.top : pillar.bottom;
  const double range = slope != 0 ? (face - height) / slope : kInfinity;
  return range >= in && range <= out ? range : kInfinity;
}

}  // namespace

void StillScene::AddBox(const Rectangle& shape, double height, Material material) {
  const auto corners = Corners(shape);
  const int roof = static_cast<int>(roofs.size());
  roofs.push_back({shape, height});
  for (std::size_t i = 0; i < 4; ++i) {
    panels.push_back({{corners[i], corners[(i + 1) % 4]}, height, material, roof});
  }
}

std::vector<Segment> EdgesFrom(double height, const StillScene& still) {
  std::vector<Segment> edges;
  for (const Panel& panel : still.panels) {
    if (panel.top >= height) edges.push_back(panel.edge);
  }
  return edges;
}

Scene::Scene(StillScene still) : still_(std::move(still)), edges_(EdgesOf(still_.panels)) {}

void Scene::CastFan(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
                    double max_range, std::vector<Hit>& hits) const {
  hits.assign(slopes.size(), {});
  MeetFloorAndCeiling(origin.z, slopes, hits);
  MeetFigures(origin, direction, slopes, hits);
  MeetPanels(origin, direction, slopes, max_range, hits);
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (hits[i].range * std::hypot(1, slopes[i]) > max_range) hits[i] = {};
  }
}

void Scene::MeetFloorAndCeiling(double height, const std::vector<double>& slopes,
                                std::vector<Hit>& hits) const {
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (slopes[i] < 0) hits[i] = {-height / slopes[i], kFloor, 0};
    if (slopes[i] > 0) hits[i] = {(still_.ceiling - height) / slopes[i], kCeiling, 0};
  }
}

void Scene::MeetFigures(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
                        std::vector<Hit>& hits) const {
  double in = 0;
  double out = 0;
  for (const Figure& figure : figures_) {
    if (!Cross(figure.bounds, origin.xy(), direction, in, out)) continue;
    for (const Pillar& part : figure.parts) {
      if (!Cross(part.disc, origin.xy(), direction, in, out)) continue;
      const double facing = (out - in) / 2 / part.disc.radius;
      for (std::size_t i = 0; i < slopes.size(); ++i) {
        const double range = CastAtPillar(part, origin.z, slopes[i], in, out);
        Offer({range, part.reflectivity, range == in ? facing : 0}, hits[i]);
      }
    }
  }
}

void Scene::MeetPanels(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
                       double max_range, std::vector<Hit>& hits) const {
  double farthest = std::min(Farthest(hits), max_range);
  for (CellWalk walk(edges_, origin.xy(), direction, farthest); walk.inside(); walk.Next()) {
    bool is_nearer = false;
    for (const std::uint32_t index : edges_.items(walk.cell())) {
      const Panel& panel = still_.panels[index];
      const double range = CastAtSegment(panel.edge, origin.xy(), direction, farthest);
      if (range < farthest) {
        is_nearer |= MeetPanel(panel, origin, direction, slopes, range, hits);
      }
    }
    if (is_nearer) farthest = std::min(Farthest(hits), max_range);
    if (farthest <= walk.border()) return;
  }
}

// True if it is nearer than what a ray had met. A ray that comes out of a box below its roof has
// gone in through the roof, if not through another side.
bool Scene::MeetPanel(const Panel& panel, const Vec3& origin, Vec2 direction,
                      const std::vector<double>& slopes, double range,
                      std::vector<Hit>& hits) const {
  const Vec2 along = panel.edge.b - panel.edge.a;
  const double side_facing = std::abs(Cross(direction, along)) / Length(along);
  bool is_nearer = false;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    if (range >= hits[i].range || origin.z + slopes[i] * range > panel.top) continue;
    double met = range;
    double facing = side_facing;
    if (panel.roof != Panel::kNoRoof && slopes[i] < 0) {
      const Roof& roof = still_.roofs[static_cast<std::size_t>(panel.roof)];
      const double through = (roof.height - origin.z) / slopes[i];
      const bool is_above = through > 0 && through < range;
      if (is_above && Distance(origin.xy() + direction * through, roof.shape) <= 0) {
        met = through;
        facing = 0;
      }
    }
    Offer({met, ReflectivityOf(panel.material), facing}, hits[i]);
    is_nearer = true;
  }
  return is_nearer;
}

}  // namespace coppice::robot::simulation
