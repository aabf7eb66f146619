// One look at what /tf says of a pair of frames, for the TfMonitor.
#ifndef COPPICE_ROBOT_APP_MONITORING_TF_SAMPLE_H_
#define COPPICE_ROBOT_APP_MONITORING_TF_SAMPLE_H_

#include <string>

#include "robot_app/common/transforms/transforms.h"
#include "robot_app/monitoring/tf_monitor.h"

namespace coppice::robot::monitoring {

/// The newest transform that is known for both frames, and where the child hangs now.
Expected<TransformSample> SampleOf(const Transforms& transforms, const std::string& parent,
                                   const std::string& child);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_TF_SAMPLE_H_
