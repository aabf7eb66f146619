#include "robot_app/perception/detection/network_output.h"

#include <cmath>
#include <cstddef>

namespace coppice::robot::perception {
namespace {

constexpr int kBoxNumbers = 4;  // before the classes
constexpr int kRowNumbers = 5;  // and whether something is there

std::string Text(const std::vector<int>& sizes) {
  std::string text;
  for (const int size : sizes) text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text.empty() ? "nothing" : text;
}

// Numbers of one box, `stride` apart.
struct Column {
  const float* first;
  std::size_t stride;
  float operator[](int i) const { return first[static_cast<std::size_t>(i) * stride]; }
};

void Add(const Column& numbers, const OutputForm& form, double least, std::vector<RawBox>& boxes) {
  const bool has_presence = form.layout != OutputLayout::kColumns;
  const int before = has_presence ? kRowNumbers : kBoxNumbers;
  RawBox box{numbers[0], numbers[1], numbers[2], numbers[3], 0, 0};
  for (int kind = 0; kind < form.classes; ++kind) {
    if (numbers[before + kind] <= box.confidence) continue;
    box.confidence = numbers[before + kind];
    box.kind = kind;
  }
  // Darknet's own layer has multiplied the classes already.
  if (form.layout == OutputLayout::kRows) box.confidence *= numbers[kBoxNumbers];
  const bool is_number = std::isfinite(box.x) && std::isfinite(box.y) && std::isfinite(box.width) &&
                         std::isfinite(box.height);
  if (is_number && box.width > 0 && box.height > 0 && box.confidence >= least) {
    boxes.push_back(box);
  }
}

}  // namespace

Expected<OutputForm> FormOf(const std::vector<int>& sizes, bool is_darknet) {
  if (is_darknet) {
    if (sizes.size() == 2 && sizes[1] > kRowNumbers) {
      return OutputForm{OutputLayout::kDarknet, sizes[1] - kRowNumbers};
    }
    return Problem{"expected an output of YOLO, boxes x (5 + classes), and found " + Text(sizes)};
  }
  if (sizes.size() == 3 && sizes[0] == 1) {
    if (sizes[1] >= sizes[2] && sizes[2] > kRowNumbers) {
      return OutputForm{OutputLayout::kRows, sizes[2] - kRowNumbers};
    }
    if (sizes[1] < sizes[2] && sizes[1] > kBoxNumbers) {
      return OutputForm{OutputLayout::kColumns, sizes[1] - kBoxNumbers};
    }
  }
  return Problem{
      "expected the output of a YOLOv5 (1 x boxes x (5 + classes)) or a YOLOv8 "
      "(1 x (4 + classes) x boxes) and found " +
      Text(sizes)};
}

std::vector<RawBox> BoxesIn(const Tensor& output, const OutputForm& form, double least_confidence) {
  std::vector<RawBox> boxes;
  const auto last = static_cast<std::size_t>(output.sizes.back());
  const auto before = static_cast<std::size_t>(output.sizes[output.sizes.size() - 2]);
  if (form.layout == OutputLayout::kColumns) {
    for (std::size_t i = 0; i < last; ++i) {
      Add({output.numbers + i, last}, form, least_confidence, boxes);
    }
  } else {
    for (std::size_t i = 0; i < before; ++i) {
      Add({output.numbers + i * last, 1}, form, least_confidence, boxes);
    }
  }
  return boxes;
}

}  // namespace coppice::robot::perception
