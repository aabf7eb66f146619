#include "bt_nodes/power/way_home.h"

#include <cmath>

namespace coppice::leaves {
namespace {

constexpr Duration kFresh = std::chrono::seconds(3);

}  // namespace

void WayHome::OnMeasured(double way, Time now) {
  if (!std::isfinite(way) || way < 0) return;
  measured_ = way;
  measured_at_ = now;
}

double WayHome::Length(double straight, Time now) const {
  return measured_ && now - measured_at_ <= kFresh ? *measured_ : detour_ * straight;
}

}  // namespace coppice::leaves
