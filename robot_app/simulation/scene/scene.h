// What stands upright in the world, for sensors that look up and down: panels on the floor that end
// at a height, figures of pillars (people), the floor and the ceiling.
//
// A sensor sends fans of rays: all rays of a fan have one direction on the floor and differ in how
// steep they are, as the rings of a lidar at one moment. What a fan meets is found once, on the
// floor, and then looked at by all of its rays.
//
//   Scene scene(panels, 2.5);
//   scene.SetFigures(figures);
//   scene.CastFan({0, 0, 1.2}, Direction(0), {-0.1, 0, 0.1}, 100, hits);  // hits[1]: the level one
#ifndef COPPICE_ROBOT_APP_SIMULATION_SCENE_SCENE_H_
#define COPPICE_ROBOT_APP_SIMULATION_SCENE_SCENE_H_

#include <limits>
#include <vector>

#include "robot_app/simulation/scene/figure.h"
#include "robot_app/simulation/scene/ray_caster.h"

namespace coppice::robot::simulation {

struct Vec3 {
  double x = 0, y = 0, z = 0;
  Vec2 xy() const { return {x, y}; }
};

/// What something is made of: how it looks to a lidar and to a camera.
enum class Material { kWall, kDoor, kFurniture, kCardboard, kPoster };

/// A side of something upright on the floor.
struct Panel {
  static constexpr int kNoRoof = -1;

  Segment edge;
  double top = 0;  ///< height of its end [m]
  Material material = Material::kWall;
  int roof = kNoRoof;  ///< which of the scene's roofs it carries
};

/// The upper side of a box.
struct Roof {
  Rectangle shape;
  double height = 0;  ///< [m]
};

/// What does not move by itself.
struct StillScene {
  /// A box with four sides and a roof.
  void AddBox(const Rectangle& shape, double height, Material material);

  std::vector<Panel> panels;
  std::vector<Roof> roofs;
  double ceiling = std::numeric_limits<double>::infinity();  ///< [m]; infinity: the sky
  double light = 1;  ///< for cameras: 1 with all lamps on, 0.02 nearly dark
};

/// Of the panels that reach up to `height` [m], where a level ray can meet them.
std::vector<Segment> EdgesFrom(double height, const StillScene& still);

/// Where a ray ends.
struct Hit {
  double range = std::numeric_limits<double>::infinity();  ///< on the floor [m]; infinity: nowhere
  double reflectivity = 0;                                 ///< 0..1, for infrared light
  /// On the floor, the cosine between the ray and the normal of what it met; 0: that lies level.
  double facing = 0;
};

class Scene {
 public:
  explicit Scene(StillScene still = {});

  const StillScene& still() const { return still_; }
  /// Of its panels, in their order.
  const RayCaster& edges() const { return edges_; }

  /// Puts the figures where they are now; those of before are gone.
  void SetFigures(std::vector<Figure> figures) { figures_ = std::move(figures); }

  /// Fills `hits` with one for each of `slopes` (tangents of the angles above the horizon,
  /// ascending). `direction` has length 1; hits farther than `max_range` metres of air are none.
  /// Const; allocates nothing once `hits` is large enough.
  void CastFan(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
               double max_range, std::vector<Hit>& hits) const;

 private:
  void MeetFloorAndCeiling(double height, const std::vector<double>& slopes,
                           std::vector<Hit>& hits) const;
  void MeetFigures(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
                   std::vector<Hit>& hits) const;
  void MeetPanels(const Vec3& origin, Vec2 direction, const std::vector<double>& slopes,
                  double max_range, std::vector<Hit>& hits) const;
  bool MeetPanel(const Panel& panel, const Vec3& origin, Vec2 direction,
                 const std::vector<double>& slopes, double range, std::vector<Hit>& hits) const;

  StillScene still_;
  RayCaster edges_;
  std::vector<Figure> figures_;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_SCENE_SCENE_H_
