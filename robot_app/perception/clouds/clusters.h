// Groups of cells of a range image that belong together: candidates for people, and all else that
// stands on the floor.
//
// Two ways to find them, which fail at different things: in the picture neighbours are joined
// unless there is a step in depth between them (fast; tells a person from the wall behind; cuts at
// what stands before), in space points are joined that are nearer than a distance that grows with
// the range (joins again what was cut; swallows what touches). Used together, fewer people are
// missed (Stuede et al., ECMR 2021, II-C1).
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CLUSTERS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CLUSTERS_H_

#include <cstdint>
#include <vector>

#include "robot_app/perception/clouds/ground.h"
#include "robot_app/perception/clouds/range_image.h"

namespace coppice::robot::perception {

/// Cluster i has the cells cells[begin[i]] up to cells[begin[i + 1]], ascending.
struct Clusters {
  std::vector<std::uint32_t> cells;
  std::vector<std::uint32_t> begin{0};

  struct Cells {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return last - first; }
  };
  std::size_t size() const { return begin.size() - 1; }
  Cells operator[](std::size_t i) const {
    return {cells.data() + begin[i], cells.data() + begin[i + 1]};
  }
  void clear() {
    cells.clear();
    begin.assign(1, 0);
  }
  /// What was put behind the last cluster's cells becomes the next cluster.
  void Close() { begin.push_back(static_cast<std::uint32_t>(cells.size())); }
};

struct DepthStepOptions {
  float angle = 0.17F;  ///< between the line through two points and the ray: less is a step [rad]
  int reach = 3;        ///< so many cells of lost returns are looked across
  std::size_t least_cells = 5;  ///< smaller groups are noise
};

/// Joins neighbours in the picture (Bogoslavskyi and Stachniss, IROS 2016: the angle beta).
/// Only what is Surface::kStanding takes part.
void ClusterByDepthSteps(const RangeImage& image, const std::vector<Surface>& surfaces,
                         const DepthStepOptions& options, Clusters& clusters);

struct DistanceOptions {
  float least = 0.1F;   ///< points so near to each other are joined at any range [m] ...
  float ring_gaps = 1;  ///< ... and farther away by so many gaps between two rings more
  float farthest = 25;  ///< nothing is joined beyond [m]
  std::size_t least_cells = 5;
};

/// Joins what is near in space; how near grows with the gaps between the rings of the sensor, as in
/// Z. Yan, T. Duckett and N. Bellotto, "Online Learning for Human Classification in 3D LiDAR-based
/// Tracking", IROS 2017. There it grows in steps, from region to region; here with each metre, so
/// nobody on a border is cut in two. Who is near is looked for in the picture: what is near in
/// space is near there too, and nothing has to be sorted (a k-d tree took more than three times as
/// many instructions).
void ClusterByDistance(const RangeImage& image, const std::vector<Surface>& surfaces,
                       const DistanceOptions& options, Clusters& clusters);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CLOUDS_CLUSTERS_H_
