// The LED strips in arms and ears as RViz draws them: one bar on the outer side of each limb, which
// moves with it.
#ifndef COPPICE_ROBOT_APP_EXPRESSION_LIGHT_MARKERS_H_
#define COPPICE_ROBOT_APP_EXPRESSION_LIGHT_MARKERS_H_

#include <visualization_msgs/MarkerArray.h>

#include <vector>

#include "robot_app/common/robot_description.h"
#include "robot_app/expression/expression_table.h"

namespace coppice::robot::expression {

/// `limbs`: in the order of kLimbs.
visualization_msgs::MarkerArray LightMarkers(const LightStep& lights,
                                             const std::vector<JointOnRobot>& limbs);

}  // namespace coppice::robot::expression

#endif  // COPPICE_ROBOT_APP_EXPRESSION_LIGHT_MARKERS_H_
