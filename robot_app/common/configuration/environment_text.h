// Texts of a configuration with variables of the environment in them: "${NAME}",
// "${NAME:-otherwise}".
#ifndef COPPICE_ROBOT_APP_COMMON_CONFIGURATION_ENVIRONMENT_TEXT_H_
#define COPPICE_ROBOT_APP_COMMON_CONFIGURATION_ENVIRONMENT_TEXT_H_

#include <functional>
#include <optional>
#include <string>

#include "bt_core/base/outcome.h"

namespace coppice::robot {

/// The value of an environment variable, or nothing.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;
/// That of this process.
std::optional<std::string> ProcessEnvironment(const std::string& name);

/// Whether the text is one variable without a default and nothing else, as secrets must be.
bool IsVariable(const std::string& text);

/// A problem if a variable has neither value nor default. An empty value counts as none. A "${"
/// that is not closed is a text like any other.
Expected<std::string> FillVariables(const std::string& text, const Environment& environment);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_CONFIGURATION_ENVIRONMENT_TEXT_H_
