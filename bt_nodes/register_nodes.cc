#include "bt_nodes/register_nodes.h"

#include <functional>
#include <memory>

#include "bt_nodes/application/application_leaves.h"
#include "bt_nodes/basics/is_true.h"
#include "bt_nodes/basics/wait.h"
#include "bt_nodes/docking/docking_leaves.h"
#include "bt_nodes/interaction/expression_leaves.h"
#include "bt_nodes/interaction/interaction_leaves.h"
#include "bt_nodes/monitoring/monitoring_leaves.h"
#include "bt_nodes/navigation/navigation_leaves.h"
#include "bt_nodes/navigation/route_leaves.h"
#include "bt_nodes/operators/help_leaves.h"
#include "bt_nodes/operators/supervisor_leaves.h"
#include "bt_nodes/operators/tell_faults.h"
#include "bt_nodes/people/people_leaves.h"
#include "bt_nodes/power/power_leaves.h"
#include "bt_nodes/processes/process_leaves.h"
#include "bt_nodes/recovery/recovery_nodes.h"
#include "bt_nodes/recovery/restart_faulty_nodes.h"
#include "bt_nodes/visitors/visitor_leaves.h"

namespace coppice::leaves {

void RegisterNodes(Registry& registry, const Capabilities& capabilities) {
  const auto navigator = std::ref(capabilities.navigator);
  registry.Register<NavigateTo>("NavigateTo", navigator);
  registry.Register<LimitSpeed>("LimitSpeed", navigator);
  registry.Register<BackUp>("BackUp", navigator);
  registry.Register<Rotate>("Rotate", navigator);
  registry.Register<ChooseWaypoint>("ChooseWaypoint", std::ref(capabilities.waypoints));
  registry.Register<FindWaypoint>("FindWaypoint", std::ref(capabilities.waypoints));
  const auto routes = std::ref(capabilities.routes);
  registry.Register<NextLeg>("NextLeg", routes);
  registry.Register<RememberLeg>("RememberLeg", routes);
  registry.Register<IsAtPlace>("IsAtPlace", routes);
  registry.Register<NearestPlace>("NearestPlace", routes);
  registry.Register<DescribePlace>("DescribePlace", routes);
  registry.Register<WayIsFree>("WayIsFree", navigator);

  registry.Register<Dock>("Dock", std::ref(capabilities.station));
  registry.Register<PressOn>("PressOn", std::ref(capabilities.station));
  registry.Register<Undock>("Undock", std::ref(capabilities.station));
  registry.Register<IsBatteryLow>("IsBatteryLow");
  registry.Register<IsCharging>("IsCharging");
  registry.Register<IsNotCharging>("IsNotCharging");
  registry.Register<IsDocked>("IsDocked");
  registry.Register<IsNotDocked>("IsNotDocked");
  registry.Register<WaitForBattery>("WaitForBattery");
  registry.Register<Charge>("Charge");
  registry.Register<ChargeDue>("ChargeDue");
  registry.Register<PlanCharge>("PlanCharge");
  registry.Register<IsOffDuty>("IsOffDuty");

  registry.Register<Say>("Say", std::ref(capabilities.interaction));
  registry.Register<SetExpression>("SetExpression", std::ref(capabilities.face));
  registry.Register<Express>("Express", std::ref(capabilities.face));
  registry.Register<Wait>("Wait");
  registry.Register<IsTrue>("IsTrue");

  registry.Register<SeesPeople>("SeesPeople");
  registry.Register<PersonInFront>("PersonInFront");
  registry.Register<NearestPerson>("NearestPerson");
  registry.Register<CountPeople>("CountPeople");
  registry.Register<FollowerBehind>("FollowerBehind");
  registry.Register<FollowerNear>("FollowerNear");
  registry.Register<MaskMissing>("MaskMissing");
  registry.Register<FacePerson>("FacePerson", navigator);

  registry.Register<VisitorArrived>("VisitorArrived");
  registry.Register<VisitorTalks>("VisitorTalks");
  registry.Register<GuideRequested>("GuideRequested");
  registry.Register<RequestStands>("RequestStands");
  registry.Register<SettleRequest>("SettleRequest", std::ref(capabilities.visitors));
  registry.Register<SayPhrase>("SayPhrase", std::ref(capabilities.interaction),
                               std::ref(capabilities.phrases));

  registry.Register<ReadHealth>("ReadHealth");
  registry.Register<NodeFault>("NodeFault");
  registry.Register<TopicFault>("TopicFault");
  registry.Register<LoggerFault>("LoggerFault");
  registry.Register<NavigationFault>("NavigationFault");
  registry.Register<LocalizationFault>("LocalizationFault");
  registry.Register<DockingFault>("DockingFault");
  registry.Register<ChargingFault>("ChargingFault");
  registry.Register<EmergencyStopFault>("EmergencyStopFault");
  registry.Register<SupervisorFault>("SupervisorFault");
  registry.Register<NodeIsWell>("NodeIsWell");
  registry.Register<RestartNode>("RestartNode", std::ref(capabilities.processes));
  registry.Register<SwitchConfiguration>("SwitchConfiguration", std::ref(capabilities.processes));
  registry.Register<SwitchSite>("SwitchSite", std::ref(capabilities.processes));
  registry.Register<SwitchOff>("SwitchOff", std::ref(capabilities.processes));
  registry.Register<AskSupervisor>("AskSupervisor", std::ref(capabilities.supervisors));
  registry.Register<TellSupervisor>("TellSupervisor", std::ref(capabilities.supervisors));
  registry.Register<TellFaults>("TellFaults", std::ref(capabilities.supervisors));
  const auto requests = std::make_shared<OpenRequests>(capabilities.supervisors);
  registry.Register<RequestHelp>("RequestHelp", requests);
  registry.Register<SettleRequests>("SettleRequests", requests);

  registry.Register<ContinueEpisode>("ContinueEpisode");
  registry.Register<Recovery>("Recovery", std::ref(capabilities.recoveries));
  registry.Register<RestartFaultyNodes>("RestartFaultyNodes", std::ref(capabilities.processes),
                                        std::ref(capabilities.recoveries));

  registry.Register<RequestCharge>("RequestCharge", std::ref(capabilities.application));
  registry.Register<AnnounceGoingHome>("AnnounceGoingHome", std::ref(capabilities.application),
                                       std::make_shared<int>(0));
  registry.Register<SuspendApplication>("SuspendApplication", std::ref(capabilities.application));
}

}  // namespace coppice::leaves
