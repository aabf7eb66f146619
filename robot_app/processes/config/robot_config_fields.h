// The parts of robot.yaml that name no other part, each read from its own fields. Used by
// LoadRobotConfig.
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_FIELDS_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_FIELDS_H_

#include "robot_app/common/yaml_fields.h"
#include "robot_app/processes/config/robot_config.h"

namespace coppice::robot::processes {

/// `restart_intensity` of the file or of a group; what is not given is as in `otherwise`.
RestartLimits ReadRestartLimits(YamlFields fields, const RestartLimits& otherwise);
BackOff ReadBackOff(YamlFields fields);
EscalationLimits ReadEscalation(YamlFields fields);
Strategy ReadStrategy(YamlFields& group);
RestartRule ReadRestartRule(YamlFields& process);
HeartbeatConfig ReadHeartbeat(YamlFields fields);

/// `ready` of a process: node, none, "topic /NAME" or "service /NAME".
void ReadReadiness(YamlFields& fields, ProcessConfig& process);

HostConfig ReadHost(const LocatedText& name, YamlFields fields);
ConditionConfig ReadCondition(const LocatedText& name, YamlFields fields);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_ROBOT_CONFIG_FIELDS_H_
