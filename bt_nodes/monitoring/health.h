// The health of the robot as the monitors see it: a value on the blackboard of the monitor tree.
#ifndef COPPICE_BT_NODES_MONITORING_HEALTH_H_
#define COPPICE_BT_NODES_MONITORING_HEALTH_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"

namespace coppice::leaves {

/// In the order of severity.
enum class HealthLevel : std::uint8_t { kOk = 0, kWarn = 1, kError = 2, kStale = 3 };

/// "OK", "WARN", "ERROR" or "STALE".
const char* ToString(HealthLevel level);
/// The level that messages give as a number. One that there is not is no reason to feel well: it
/// counts as the worst.
HealthLevel LevelOfNumber(int number);

/// One thing that a monitor watches.
struct HealthEntry {
  std::string monitor;  ///< kind of monitor: node, topic, navigation, localization, ...
  std::string subject;  ///< what is watched
  std::string node;     ///< ROS node to restart if this is an error; empty if none
  HealthLevel level = HealthLevel::kOk;
  std::string message;  ///< for people
};

/// True if the list, separated by semicolons, has that kind of monitor.
bool ListsKind(std::string_view kinds, std::string_view monitor);

struct Health {
  Time stamp{};  ///< of the tree's clock, when the report arrived; zero: never
  std::vector<HealthEntry> entries;

  /// The first entry of that kind of monitor that is an error or stale, or null.
  const HealthEntry* FirstError(std::string_view monitor) const;
  /// True if there is such an entry of one of the kinds, which are separated by semicolons.
  bool HasError(std::string_view kinds) const;
};

}  // namespace coppice::leaves

/// Text form: the stamp in ns, then one line per entry: level, monitor, subject, node and message,
/// tab-separated.
template <>
struct coppice::ValueTraits<coppice::leaves::Health> {
  static constexpr const char* kName = "Health";
  static bool Parse(std::string_view text, leaves::Health& out);
  static std::string Print(const leaves::Health& value);
};

#endif  // COPPICE_BT_NODES_MONITORING_HEALTH_H_
