#include "robot_app/monitoring/gauges/band_fields.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "robot_app/common/ros_name.h"

namespace coppice::robot::monitoring {
namespace {

constexpr double kHighestBound = 1e12;
constexpr double kLongestStaleness = 7 * 86400;

std::optional<double> ReadBound(const YamlFields& fields, const std::string& key,
                                const LocatedText& bound) {
  if (bound.text == "none") return std::nullopt;
  double number = 0;
  const bool is_number = YAML::convert<double>::decode(YAML::Node(bound.text), number);
  if (is_number && std::abs(number) <= kHighestBound) return number;
  fields.Error(bound.where,
               "\"" + key + "\": expected a number or none, got \"" + bound.text + "\"");
  return std::nullopt;
}

// "[low, high]", each a number or "none".
Range ReadRange(YamlFields& fields, const std::string& key, const Range& otherwise) {
  const bool is_given = fields.Has(key);
  const std::vector<LocatedText> bounds = fields.Texts(key);
  if (!is_given) return otherwise;
  if (bounds.size() != 2) {
    fields.Error(fields.where(), "\"" + key + "\": expected [low, high]");
    return otherwise;
  }
  const Range range{ReadBound(fields, key, bounds[0]), ReadBound(fields, key, bounds[1])};
  if (range.low && range.high && *range.low >= *range.high) {
    fields.Error(bounds[0].where, "\"" + key + "\": low is not below high");
  }
  return range;
}

bool IsWithin(const Range& inner, const Range& outer) {
  return !(inner.low && outer.low && *inner.low < *outer.low) &&
         !(inner.high && outer.high && *inner.high > *outer.high);
}

// A default that does not fit what the file says gives way.
void Fit(const YamlFields& fields, Band& band) {
  const auto fit = [](std::optional<double>& bound, const std::optional<double>& given, bool grow) {
    if (bound && given) bound = grow ? std::max(*bound, *given) : std::min(*bound, *given);
  };
  if (!fields.Has("warn")) {
    fit(band.warn.low, band.error.low, true);
    fit(band.warn.high, band.error.high, false);
  } else if (!fields.Has("error")) {
    fit(band.error.low, band.warn.low, false);
    fit(band.error.high, band.warn.high, true);
  }
}

bool LeavesRoom(const Range& range, double hysteresis) {
  return !(range.low && range.high) || *range.high - *range.low > 2 * hysteresis;
}

}  // namespace

Band ReadBandKeys(YamlFields& fields, const Band& otherwise) {
  Band band;
  band.warn = ReadRange(fields, "warn", otherwise.warn);
  band.error = ReadRange(fields, "error", otherwise.error);
  Fit(fields, band);
  band.consecutive = fields.Integer("consecutive", otherwise.consecutive, 1, 1000);
  band.staleness =
      fields.Seconds("staleness", std::chrono::duration<double>(otherwise.staleness).count(), 0,
                     kLongestStaleness);
  band.hysteresis = fields.Number("hysteresis", otherwise.hysteresis, 0, kHighestBound);
  if (!IsWithin(band.warn, band.error)) {
    fields.Error(fields.where(), "\"warn\" is not within \"error\"");
  }
  if (!LeavesRoom(band.warn, band.hysteresis) || !LeavesRoom(band.error, band.hysteresis)) {
    fields.Error(fields.where(), "\"hysteresis\" leaves no room between low and high");
  }
  return band;
}

Band ReadBand(YamlFields& fields, const std::string& key, const Band& otherwise) {
  YamlFields keys = fields.Map(key);
  const Band band = ReadBandKeys(keys, otherwise);
  keys.Finish();
  return band;
}

std::string ReadRosName(YamlFields& fields, const std::string& key) {
  const LocatedText name = fields.Text(key);
  if (!name.text.empty()) ExpectRosName(fields, key, name);
  return name.text;
}

std::string ReadRosName(YamlFields& fields, const std::string& key, const std::string& otherwise) {
  if (fields.Has(key)) return ReadRosName(fields, key);
  return fields.Text(key, otherwise).text;
}

void CheckUnique(const YamlFields& fields, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (!seen.insert(name).second) {
      fields.Error(fields.where(), "\"" + name + "\" is listed twice");
    }
  }
}

}  // namespace coppice::robot::monitoring
