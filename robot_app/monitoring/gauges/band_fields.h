// Bands in YAML: every monitor writes its bounds in the same words.
//
//   load: {warn: [none, 0.9], error: [none, 0.97], consecutive: 3, staleness: 5, hysteresis: 0.02}
#ifndef COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_FIELDS_H_
#define COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_FIELDS_H_

#include <string>
#include <vector>

#include "robot_app/common/yaml_fields.h"
#include "robot_app/monitoring/gauges/band.h"

namespace coppice::robot::monitoring {

/// The mapping `key`; what it does not say is taken from `otherwise`. `warn` must lie within
/// `error`; if only one of them is given, the default of the other gives way.
Band ReadBand(YamlFields& fields, const std::string& key, const Band& otherwise = {});

/// The same words among other keys of `fields`.
Band ReadBandKeys(YamlFields& fields, const Band& otherwise = {});

/// A ROS name that must begin with a slash.
std::string ReadRosName(YamlFields& fields, const std::string& key);
/// The same, but may be missing: then it is `otherwise`.
std::string ReadRosName(YamlFields& fields, const std::string& key, const std::string& otherwise);

/// `names` that occur twice are an error.
void CheckUnique(const YamlFields& fields, const std::vector<std::string>& names);

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_GAUGES_BAND_FIELDS_H_
