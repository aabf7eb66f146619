#include "robot_app/deployment/robot/manager.h"

namespace coppice::robot::deployment {
namespace {

using leaves::ActionResult;

constexpr char kToken[] = "deployment";  // of who may cut the power

ActionResult Answer(const Expected<std::string>& result) {
  return result ? ActionResult{true, *result} : ActionResult{false, result.problem()};
}

}  // namespace

Manager::Manager(World& world, Programs& programs, const processes::RobotConfig& config)
    : world_(world), programs_(programs) {
  Reset();
  for (const processes::ConditionConfig& condition : config.conditions) {
    conditions_.emplace_back(condition);
  }
}

void Manager::RestartNode(const std::string& node, bool cleared, Sender<ActionResult> done) {
  done.Send(Answer(programs_.supervisor().Restart(node, world_.now(), cleared)));
}

void Manager::SetConfiguration(const std::string& configuration) {
  OnCurrent(world_.current);
  const auto check = [this](std::size_t condition) {
    return conditions_[condition].Check(world_.now());
  };
  (void)programs_.supervisor().SetConfiguration(configuration, processes::Hand::kTree, check);
}

void Manager::SetSite(const std::string& site, Sender<ActionResult> done) {
  done.Send(Answer(programs_.supervisor().SetSite(
      site, processes::Hand::kTree,
      [](const std::string&) -> Outcome { return Problem{"the deployment is at one site"}; })));
}

void Manager::SwitchOff(const std::string& reason, Sender<ActionResult> done) {
  done.Send(Answer(power_down_->Ask(reason, kToken, programs_.supervisor(), world_.now())));
}

void Manager::OnCurrent(double current) {
  for (processes::TopicCondition& condition : conditions_) {
    condition.Observe(current, world_.now());
  }
}

bool Manager::TakeCut() {
  (void)power_down_->TakeStop(programs_.supervisor(), world_.now());
  return power_down_->may_cut();
}

void Manager::Reset() { power_down_.emplace(true, kToken); }

}  // namespace coppice::robot::deployment
