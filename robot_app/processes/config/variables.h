// Variables in the texts of a configuration file: "${bin}/coppice-robot", "${speed:-1}".
#ifndef COPPICE_ROBOT_APP_PROCESSES_CONFIG_VARIABLES_H_
#define COPPICE_ROBOT_APP_PROCESSES_CONFIG_VARIABLES_H_

#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "bt_core/base/advisor.h"

namespace coppice::robot::processes {

/// Values of `${name}`. `${name:-default}` stands for the default if there is none; the default may
/// contain variables.
using Variables = std::map<std::string, std::string>;

/// No text with variables stands for more [bytes].
inline constexpr std::size_t kLongestFilled = std::size_t{64} << 10;

/// The text with all variables filled in. What is wrong is reported with a hint (may be empty), and
/// stands for nothing: also a text that would be too long, and more than 16 defaults within each
/// other.
std::string FillVariables(
    const std::string& text, const Variables& variables, Advisor& advisor,
    const std::function<void(const std::string& message, const std::string& hint)>& report);

}  // namespace coppice::robot::processes

#endif  // COPPICE_ROBOT_APP_PROCESSES_CONFIG_VARIABLES_H_
