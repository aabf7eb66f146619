#include "bt_nodes/navigation/route_leaves.h"

namespace coppice::leaves {

Status NextLeg::Run() {
  const auto next = routes_.NextLeg(*pose, *place, *language);
  if (!next) return Fail(next.problem());
  if (!*next) return Fail("the robot is there");
  const RouteLeg& found = **next;
  leg.Set(found.name);
  kind.Set(found.kind);
  goal.Set(found.goal);
  spoken.Set(found.spoken);
  return Status::kSuccess;
}

Status RememberLeg::Run() {
  routes_.Ended(*leg, *travelled, *pose);
  return Status::kSuccess;
}

bool IsAtPlace::Check() { return routes_.IsAt(*pose, *place); }

Status NearestPlace::Run() {
  const auto nearest = routes_.Nearest(*pose, *category);
  if (!nearest) return Fail(nearest.problem());
  place.Set(*nearest);
  return Status::kSuccess;
}

Status DescribePlace::Run() {
  const auto description = routes_.Describe(*pose, *place, *language);
  if (!description) return Fail(description.problem());
  spoken.Set(description->spoken);
  words.Set(description->words);
  return Status::kSuccess;
}

}  // namespace coppice::leaves
