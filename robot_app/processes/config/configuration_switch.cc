#include "robot_app/processes/config/configuration_switch.h"

#include <vector>

namespace coppice::robot::processes {

Expected<std::string> ConfigurationSwitch::Request(const std::string& name, Hand hand,
                                                   const CheckCondition& check) {
  std::vector<std::string> names;
  std::size_t wanted = config_.configurations.size();
  for (std::size_t i = 0; i < config_.configurations.size(); ++i) {
    names.push_back(config_.configurations[i].name);
    if (names.back() == name) wanted = i;
  }
  if (wanted == names.size()) {
    return Problem{"no configuration \"" + name + "\" " + DidYouMean(name, names)};
  }
  if (safe_stop_) return Problem{"the robot is in a safe stop until what was given up is reset"};
  if (manual_ && hand == Hand::kTree && wanted != current_) {
    return Problem{"configuration " + names[current_] + " is held by hand until it is released"};
  }
  if (wanted != current_) {
    for (const std::size_t condition : config_.configurations[wanted].requires_conditions) {
      const Outcome holds = check(condition);
      if (holds) continue;
      return Problem{"configuration " + name + " requires " + config_.conditions[condition].name +
                     ": " + holds.problem()};
    }
  }
  if (hand == Hand::kPerson) manual_ = true;
  if (wanted == current_) return "configuration " + name + " is already in force";
  current_ = wanted;
  return "changing to configuration " + name;
}

std::string ConfigurationSwitch::Release() {
  if (!manual_) return "no configuration is held by hand";
  manual_ = false;
  return "the trees decide about the configuration again";
}

void ConfigurationSwitch::SafeStop() {
  if (safe_stop_ || !config_.given_up.configuration) return;
  safe_stop_ = true;
  before_ = current_;
  current_ = *config_.given_up.configuration;
}

void ConfigurationSwitch::EndSafeStop() {
  if (!safe_stop_) return;
  safe_stop_ = false;
  current_ = before_;
}

void ConfigurationSwitch::Restore(std::size_t configuration, bool manual, bool safe_stop) {
  current_ = configuration;
  manual_ = manual;
  if (safe_stop) SafeStop();
}

}  // namespace coppice::robot::processes
