#include "robot_app/slam/map/sight.h"

namespace coppice::robot::slam {
namespace {

constexpr int kEvery = 6;        // pixels of a row, and rows: 5 cm at the farthest
constexpr double kFarthest = 4;  // m; twice as far a depth is four times less exact
constexpr float kKeptEdge = 0.05F;

CameraCloud CloudOf(const DepthPicture& depth, const CameraMount& camera) {
  const Lens& lens = camera.lens;
  CloudPoints points;
  for (int row = kEvery / 2; row < depth.height; row += kEvery) {
    for (int column = kEvery / 2; column < depth.width; column += kEvery) {
      const double z = 1e-3 * depth.at(column, row);
      if (z <= 0 || z > kFarthest) continue;
      const Eigen::Vector3d optical((column - lens.cx) / lens.fx * z, (row - lens.cy) / lens.fy * z,
                                    z);
      points.push_back((camera.optical_in_base * optical).cast<float>());
    }
  }
  return {camera.optical_in_base.translation().cast<float>(),
          Thinned(points, kKeptEdge, 2 * static_cast<float>(kFarthest))};
}

}  // namespace

SightPicture SeePicture(const Picture& colour, const DepthPicture& depth,
                        const CameraMount& camera) {
  const DepthPicture none;
  const DepthPicture& measured = HaveOneSize(colour, depth) ? depth : none;
  return {FindFeatures(colour, measured, camera), camera, CloudOf(measured, camera)};
}

}  // namespace coppice::robot::slam
