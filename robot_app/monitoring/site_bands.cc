#include "robot_app/monitoring/site_bands.h"

#include <optional>

#include "robot_app/common/yaml_fields.h"
#include "robot_app/monitoring/gauges/band_fields.h"
#include "robot_app/monitoring/power/power_fields.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kHour = 3600;

struct SiteBands {
  std::optional<double> blocked, no_path, after_failure;  // s
  std::optional<Band> since_confirmed, score, deviation, map_jump;
  std::optional<DockPlace> dock;
};

std::optional<Band> OptionalBand(YamlFields& fields, const std::string& key) {
  const bool is_given = fields.Has(key);
  const Band band = ReadBand(fields, key);
  return is_given ? std::optional(band) : std::nullopt;
}

SiteBands Read(YamlFields file) {
  SiteBands bands;
  YamlFields navigation = file.Map("navigation");
  bands.blocked = navigation.OptionalNumber("blocked", 0, kHour);
  bands.no_path = navigation.OptionalNumber("no_path", 0, kHour);
  bands.after_failure = navigation.OptionalNumber("after_failure", 0, kHour);
  navigation.Finish();
  YamlFields localization = file.Map("localization");
  bands.since_confirmed = OptionalBand(localization, "since_confirmed");
  bands.score = OptionalBand(localization, "score");
  bands.deviation = OptionalBand(localization, "deviation");
  localization.Finish();
  bands.map_jump = OptionalBand(file, "map_jump");
  const bool has_dock = file.Has("dock");
  YamlFields dock = file.Map("dock");
  if (has_dock) bands.dock = ReadDock(dock);
  file.Finish();
  return bands;
}

void Set(const std::optional<double>& seconds, Duration& duration) {
  if (!seconds) return;
  duration = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(*seconds));
}

void Set(const std::optional<Band>& given, Band& band) {
  if (given) band = *given;
}

void Use(const SiteBands& bands, WatchList& list) {
  if (list.navigation) {
    Set(bands.blocked, list.navigation->blocked);
    Set(bands.no_path, list.navigation->no_path);
    Set(bands.after_failure, list.navigation->after_failure);
  }
  if (list.localization) {
    Set(bands.since_confirmed, list.localization->since_confirmed);
    Set(bands.score, list.localization->score);
    Set(bands.deviation, list.localization->deviation);
  }
  for (TransformWatch& transform : list.transforms) {
    const bool is_localization = transform.parent == "map" && transform.child == "odom";
    if (is_localization && list.localization) Set(bands.map_jump, transform.jump);
  }
  if (list.battery && bands.dock) list.battery->dock = bands.dock;
}

}  // namespace

void ReadSiteBands(const std::string& path, MonitorConfig& config, Diagnostics& diagnostics) {
  const SiteBands bands = Read(YamlFields::Load(path, diagnostics));
  for (WatchList& list : config.lists) Use(bands, list);
}

}  // namespace coppice::robot::monitoring
