// The lists of what is watched about nodes, topics and movement, read from YAML. Each function
// takes the mapping of one item and finishes it.
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_FIELDS_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_FIELDS_H_

#include "robot_app/common/yaml_fields.h"
#include "robot_app/monitoring/gauges/watch.h"

namespace coppice::robot::monitoring {

NodeWatch ReadNodeWatch(YamlFields& fields, int default_misses);
PublisherWatch ReadPublisherWatch(YamlFields& fields);
TopicWatch ReadTopicWatch(YamlFields& fields, double default_window);
NavigationWatch ReadNavigationWatch(YamlFields& fields);
LocalizationWatch ReadLocalizationWatch(YamlFields& fields);
TransformWatch ReadTransformWatch(YamlFields& fields);
LoggerWatch ReadLoggerWatch(YamlFields& fields);
DiagnosticsWatch ReadDiagnosticsWatch(YamlFields& fields);
SourceWatch ReadSourceWatch(YamlFields& fields);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_WATCH_FIELDS_H_
