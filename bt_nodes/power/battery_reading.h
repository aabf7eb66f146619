// What a battery's electronics and its charger report. What is not measured is unknown and is never
// taken for a number: whoever decides by it says what he does then.
#ifndef COPPICE_BT_NODES_POWER_BATTERY_READING_H_
#define COPPICE_BT_NODES_POWER_BATTERY_READING_H_

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "bt_core/base/clock.h"
#include "bt_core/data/value.h"

namespace coppice::leaves {

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// What the charger says. The numbers are those of sensor_msgs/BatteryState.
enum class ChargerState : std::uint8_t {
  kUnknown = 0,
  kCharging = 1,
  kDischarging = 2,  ///< no contact with the station
  kNotCharging = 3,  ///< contact, but no current
  kFull = 4,         ///< contact, and no more current is needed
};

struct BatteryReading {
  Time stamp{};                   ///< of the tree's clock, when it arrived; zero: never
  double voltage = kNotMeasured;  ///< V, at the terminals
  double current = kNotMeasured;  ///< A, negative: discharging
  double level = kNotMeasured;    ///< state of charge, 0..1
  double charge = kNotMeasured;   ///< Ah
  ChargerState charger = ChargerState::kUnknown;
};

/// Does charging current flow? Where the charger says nothing, a current of more than
/// `charging_above` [A] counts. Nothing: not known.
std::optional<bool> CurrentFlows(const BatteryReading& reading, double charging_above = 0.5);

/// Do the contacts of the station touch, be it with current, without, or with a full battery? Where
/// the charger says nothing, a current of more than `charging_above` [A] to either side tells it.
/// Nothing: not known.
std::optional<bool> StandsOnStation(const BatteryReading& reading, double charging_above = 0.5);

}  // namespace coppice::leaves

/// Text form: "stamp;voltage;current;level;charge;charger", the stamp in ns, the charger's state as
/// its number, "nan" for what is not measured.
template <>
struct coppice::ValueTraits<coppice::leaves::BatteryReading> {
  static constexpr const char* kName = "BatteryReading";
  static bool Parse(std::string_view text, leaves::BatteryReading& out);
  static std::string Print(const leaves::BatteryReading& value);
};

#endif  // COPPICE_BT_NODES_POWER_BATTERY_READING_H_
