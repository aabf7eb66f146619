// Makes all leaves of the robot known to a Registry.
#ifndef COPPICE_BT_NODES_REGISTER_NODES_H_
#define COPPICE_BT_NODES_REGISTER_NODES_H_

#include "bt_core/engine/registry.h"
#include "bt_nodes/application/application_control.h"
#include "bt_nodes/docking/charging_station.h"
#include "bt_nodes/interaction/expression.h"
#include "bt_nodes/interaction/interaction.h"
#include "bt_nodes/navigation/navigator.h"
#include "bt_nodes/navigation/routes.h"
#include "bt_nodes/navigation/waypoint_map.h"
#include "bt_nodes/operators/supervisor_channel.h"
#include "bt_nodes/processes/process_manager.h"
#include "bt_nodes/recovery/recovery_log.h"
#include "bt_nodes/visitors/phrases.h"
#include "bt_nodes/visitors/visitor.h"

namespace coppice::leaves {

/// What the leaves act on. All of it must live as long as the trees that use it.
struct Capabilities {
  Navigator& navigator;
  WaypointMap& waypoints;
  Routes& routes;
  ChargingStation& station;
  Interaction& interaction;
  Face& face;
  Visitors& visitors;
  Phrases& phrases;
  ProcessManager& processes;
  SupervisorChannel& supervisors;
  ApplicationControl& application;
  RecoveryLog& recoveries;
};

/// One registry for each tree that runs: the leaves of one registry share its requests for help.
void RegisterNodes(Registry& registry, const Capabilities& capabilities);

}  // namespace coppice::leaves

#endif  // COPPICE_BT_NODES_REGISTER_NODES_H_
