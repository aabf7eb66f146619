#include "robot_app/common/configuration/environment_text.h"

#include <cstdlib>

namespace coppice::robot {

std::optional<std::string> ProcessEnvironment(const std::string& name) {
  const char* const value = std::getenv(name.c_str());
  return value ? std::optional<std::string>(value) : std::nullopt;
}

bool IsVariable(const std::string& text) {
  return text.size() > 3 && text.compare(0, 2, "${") == 0 && text.find('}') == text.size() - 1 &&
         text.find(":-") == std::string::npos;
}

Expected<std::string> FillVariables(const std::string& text, const Environment& environment) {
  std::string filled;
  std::size_t position = 0;
  while (true) {
    const std::size_t begin = text.find("${", position);
    const std::size_t end = begin == std::string::npos ? begin : text.find('}', begin);
    if (end == std::string::npos) return filled + text.substr(position);
    filled += text.substr(position, begin - position);
    const std::string expression = text.substr(begin + 2, end - begin - 2);
    const std::size_t separator = expression.find(":-");
    const std::string name = expression.substr(0, separator);
    const std::optional<std::string> value = environment(name);
    if (value && !value->empty()) {
      filled += *value;
    } else if (separator != std::string::npos) {
      filled += expression.substr(separator + 2);
    } else {
      return Problem{"the environment variable " + name + " is not set"};
    }
    position = end + 1;
  }
}

}  // namespace coppice::robot
