// Pictures in shades of gray, and their simplest file format: PGM, "P5"
// (https://netpbm.sourceforge.net/doc/pgm.html).
#ifndef COPPICE_ROBOT_APP_MAPPING_GRAY_PICTURE_H_
#define COPPICE_ROBOT_APP_MAPPING_GRAY_PICTURE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice::robot::mapping {

struct GrayPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< row by row from the upper left corner; 255 is white
};

/// The file's content.
std::string ToPgm(const GrayPicture& picture);

/// Reads a file of at most 64 million pixels; nothing, with the reason, if it is none.
std::optional<GrayPicture> LoadPgm(const std::string& path, Diagnostics& diagnostics);

}  // namespace coppice::robot::mapping

#endif  // COPPICE_ROBOT_APP_MAPPING_GRAY_PICTURE_H_
