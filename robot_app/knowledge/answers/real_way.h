// The nearest place is the one that is soonest reached, not the one that is next as the crow flies:
// joins the knowledge with the map of the ways.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REAL_WAY_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REAL_WAY_H_

#include "robot_app/common/places/route_guide.h"
#include "robot_app/knowledge/store/queries.h"

namespace coppice::robot::knowledge {

/// How long the robot needs from where it is to a place [s], or people where it cannot go. Where no
/// edges of the map lead, twice as long as the crow flies; infinite where even that is not known.
/// `guide` must outlive the function.
WayTo RealWay(const RouteGuide& guide, const Pose2D& robot);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_REAL_WAY_H_
