#include "bt_nodes/navigation/pose2d.h"

#include <cmath>

namespace coppice {

bool ValueTraits<leaves::Pose2D>::Parse(std::string_view text, leaves::Pose2D& out) {
  for (double* number : {&out.x, &out.y, &out.yaw}) {
    const std::size_t end = text.find(';');
    const bool last = number == &out.yaw;
    if (last != (end == std::string_view::npos)) return false;
    if (!ValueTraits<double>::Parse(text.substr(0, end), *number)) return false;
    if (!std::isfinite(*number)) return false;
    if (!last) text.remove_prefix(end + 1);
  }
  return true;
}

std::string ValueTraits<leaves::Pose2D>::Print(const leaves::Pose2D& value) {
  const auto print = ValueTraits<double>::Print;
  return print(value.x) + ";" + print(value.y) + ";" + print(value.yaw);
}

}  // namespace coppice
