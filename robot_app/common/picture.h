// A colour picture, and a picture of depths, as plain values.
#ifndef COPPICE_ROBOT_APP_COMMON_PICTURE_H_
#define COPPICE_ROBOT_APP_COMMON_PICTURE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coppice::robot {

using Colour = std::array<std::uint8_t, 3>;  // red, green, blue

/// Rows from the top, three bytes a pixel: red, green, blue.
struct Picture {
  Picture() = default;
  Picture(int columns, int rows)
      : width(columns), height(rows), rgb(static_cast<std::size_t>(3) * columns * rows) {}

  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;

  Colour at(int column, int row) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(row) * width + column);
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

/// Rows from the top. How far each pixel's point is along the optical axis [mm]; 0: not measured.
struct DepthPicture {
  DepthPicture() = default;
  DepthPicture(int columns, int rows)
      : width(columns), height(rows), millimetres(static_cast<std::size_t>(columns) * rows) {}

  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> millimetres;

  std::uint16_t at(int column, int row) const {
    return millimetres[static_cast<std::size_t>(row) * width + column];
  }
};

/// Whether each pixel's depth is known beside its colour.
inline bool HaveOneSize(const Picture& colour, const DepthPicture& depth) {
  return colour.width == depth.width && colour.height == depth.height;
}

/// A pinhole: the point (x, y, z) of the optical frame (z forward, x right, y down) is seen at the
/// pixel (cx + fx x / z, cy + fy y / z).
struct Lens {
  double fx = 0, fy = 0;  ///< [pixels]
  double cx = 0, cy = 0;  ///< [pixels]
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PICTURE_H_
