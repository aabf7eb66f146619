// The private parameters (~name) of a ROS program. Each is said once, in a table: where its value
// goes, which holds the default, what is allowed, what it means. From the table come reading and
// checking, the text of --help, and docs/parameters.md.
//
//   struct Settings {
//     double speed = 0.7;
//     std::string frame = "map";
//   };
//   Parameters ParametersOf(Settings& settings) {
//     return {{"speed", &settings.speed, 0.05, 3, "at most [m/s]"},
//             {"frame", &settings.frame, "in which the robot is described"}};
//   }
//
// StartNode (ros_support.h) reads them. Nothing here needs a ROS master.
#ifndef COPPICE_ROBOT_APP_COMMON_PARAMETERS_H_
#define COPPICE_ROBOT_APP_COMMON_PARAMETERS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "robot_app/common/pose2d.h"

namespace XmlRpc {
class XmlRpcValue;
}

namespace coppice::robot {

/// One parameter. `value` holds the default, and is set by ReadParameters; it must live until then.
/// `meaning` is one line with the unit in brackets.
struct Parameter {
  using Target = std::variant<bool*, int*, std::uint64_t*, double*, std::string*,
                              std::optional<Point2D>*, std::optional<Pose2D>*>;

  /// A number in [low, high]; a whole one if `value` is of a type of whole numbers.
  template <typename Number>
  Parameter(std::string name, Number* value, double low, double high, std::string meaning)
      : name(std::move(name)), target(value), low(low), high(high), meaning(std::move(meaning)) {}
  /// A text, true or false; or a place "X Y" or pose "X Y YAW", or none.
  template <typename Value>
  Parameter(std::string name, Value* value, std::string meaning)
      : name(std::move(name)), target(value), meaning(std::move(meaning)) {
    static_assert(!std::is_arithmetic_v<Value> || std::is_same_v<Value, bool>,
                  "a number needs the range that it must lie in");
  }

  std::string name;  ///< without ~
  Target target;
  double low = 0, high = 0;  ///< of a number
  std::string meaning;
};

using Parameters = std::vector<Parameter>;

/// Sets the targets of the parameters that are `given`: what the parameter server holds under the
/// node's name, a struct if there is something. Returns what is wrong with it, one line each: a
/// value of another type or out of range, whose target keeps its default; an unknown parameter,
/// with the nearest right name.
std::vector<std::string> ReadParameters(const Parameters& parameters,
                                        const XmlRpc::XmlRpcValue& given);

/// The table for people, one line each: name, value, range, meaning, at least two spaces apart.
/// Call it before ReadParameters: the values are the defaults.
std::string Explain(const Parameters& parameters);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_PARAMETERS_H_
