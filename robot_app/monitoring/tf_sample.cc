#include "robot_app/monitoring/tf_sample.h"

#include "robot_app/monitoring/aggregator/health_messages.h"

namespace coppice::robot::monitoring {

Expected<TransformSample> SampleOf(const Transforms& transforms, const std::string& parent,
                                   const std::string& child) {
  const auto found = transforms.Find(parent, child, ros::Time());
  if (!found) return Problem{found.problem()};
  TransformSample sample;
  sample.stamp = FromRos(found->header.stamp);
  sample.x = found->transform.translation.x;
  sample.y = found->transform.translation.y;
  sample.z = found->transform.translation.z;
  sample.hangs_on = transforms.ParentOf(child);
  return sample;
}

}  // namespace coppice::robot::monitoring
