#include "behaviortree_cpp/actions/test_node.h"

#include <utility>

namespace BT {

TestNode::TestNode(const std::string& name, const NodeConfig& config,
                   std::shared_ptr<TestNodeConfig> test_config)
    : StatefulActionNode(name, config), test_config_(std::move(test_config)) {
  setRegistrationID("TestNode");
  if (test_config_->return_status == NodeStatus::IDLE) {
    throw RuntimeError("TestNode can not return IDLE");
  }
  for (const std::string* script :
       {&test_config_->success_script, &test_config_->failure_script, &test_config_->post_script,
        &test_config_->return_status_script}) {
    const Result valid = script->empty() ? Result() : ValidateScript(*script);
    if (!valid) throw RuntimeError("Error in the script \"", *script, "\"\n", valid.error());
  }
}

NodeStatus TestNode::onStart() {
  if (test_config_->async_delay <= std::chrono::milliseconds(0)) return Complete();
  end_ = std::chrono::steady_clock::now() + test_config_->async_delay;
  return NodeStatus::RUNNING;
}

NodeStatus TestNode::onRunning() {
  return std::chrono::steady_clock::now() < end_ ? NodeStatus::RUNNING : Complete();
}

NodeStatus TestNode::ResultNow(Ast::Environment& environment) const {
  if (test_config_->complete_func) return test_config_->complete_func();
  if (test_config_->return_status_script.empty()) return test_config_->return_status;
  ScriptingEnumsRegistry enums = environment.enums ? *environment.enums : ScriptingEnumsRegistry();
  for (int status = 0; status <= 4; ++status) {
    enums.emplace(toStr(static_cast<NodeStatus>(status)), status);
  }
  Ast::Environment with_statuses{environment.vars,
                                 std::make_shared<ScriptingEnumsRegistry>(std::move(enums))};
  const auto value = ParseScriptAndExecute(with_statuses, test_config_->return_status_script);
  if (!value) throw RuntimeError(value.error());
  return value->isString() ? convertFromString<NodeStatus>(value->cast<std::string>())
                           : static_cast<NodeStatus>(value->cast<int>());
}

NodeStatus TestNode::Complete() {
  Ast::Environment environment{config().blackboard, config().enums};
  const NodeStatus status = ResultNow(environment);
  const auto run = [&](const std::string& script) {
    if (script.empty()) return;
    const auto done = ParseScriptAndExecute(environment, script);
    if (!done) throw RuntimeError(done.error());
  };
  if (status == NodeStatus::SUCCESS) run(test_config_->success_script);
  if (status == NodeStatus::FAILURE) run(test_config_->failure_script);
  run(test_config_->post_script);
  return status;
}

}  // namespace BT
