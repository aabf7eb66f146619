// What is watched about computers, read from YAML.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_FIELDS_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_FIELDS_H_

#include "robot_app/common/yaml_fields.h"
#include "robot_app/monitoring/system/system_watch.h"

namespace coppice::robot::monitoring {

/// Takes the mapping of one computer and finishes it.
SystemWatch ReadSystemWatch(YamlFields& fields);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_SYSTEM_FIELDS_H_
