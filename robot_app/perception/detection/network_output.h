// What networks that find things say, in the layouts in which they say it.
//
//   Darknet (YOLOv3)   each row of each output: x, y, width, height, something there, classes...
//                      as shares of the picture
//   rows (YOLOv5)      1 x boxes x (5 + classes), the same order, in pixels of the input
//   columns (YOLOv8)   1 x (4 + classes) x boxes, without "something there", in pixels of the input
#ifndef COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_OUTPUT_H_
#define COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_OUTPUT_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"

namespace coppice::robot::perception {

/// Numbers of an output and its sizes, outermost first.
struct Tensor {
  std::vector<int> sizes;
  const float* numbers = nullptr;
};

enum class OutputLayout { kDarknet, kRows, kColumns };

struct OutputForm {
  OutputLayout layout = OutputLayout::kRows;
  int classes = 0;
};

/// Recognized by its sizes. What is none of the layouts is a problem that names the sizes.
Expected<OutputForm> FormOf(const std::vector<int>& sizes, bool is_darknet);

struct RawBox {
  float x = 0, y = 0, width = 0, height = 0;  ///< middle and size, in the units of the layout
  int kind = 0;                               ///< index of the class
  float confidence = 0;
};

/// Boxes with at least this confidence in their surest class. Numbers that are none are left out.
std::vector<RawBox> BoxesIn(const Tensor& output, const OutputForm& form, double least_confidence);

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_DETECTION_NETWORK_OUTPUT_H_
