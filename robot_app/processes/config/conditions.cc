#include "robot_app/processes/config/conditions.h"

#include <sstream>

#include "robot_app/processes/restart_budget.h"

namespace coppice::robot::processes {

void TopicCondition::Observe(double value, Time now) {
  const bool gap = heard_at_ && now - *heard_at_ > config_.staleness;
  value_ = value;
  heard_at_ = now;
  if (!Holds(value) || gap) holds_since_.reset();
  if (Holds(value) && !holds_since_) holds_since_ = now;
}

Outcome TopicCondition::Check(Time now) const {
  if (!heard_at_) return Problem{"nothing was heard on " + config_.topic};
  if (now - *heard_at_ > config_.staleness) {
    return Problem{config_.topic + " is silent for " + SecondsText(now - *heard_at_)};
  }
  if (!holds_since_) {
    if (!config_.current) return Problem{config_.topic + " says no"};
    std::ostringstream text;
    text << "only " << value_ << " A flow, " << *config_.current << " A are needed";
    return Problem{text.str()};
  }
  if (now - *holds_since_ >= config_.lasting) return {};
  return Problem{"true for " + SecondsText(now - *holds_since_) + " only, it must last " +
                 SecondsText(config_.lasting)};
}

}  // namespace coppice::robot::processes
