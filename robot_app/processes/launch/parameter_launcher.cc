#include "robot_app/processes/launch/parameter_launcher.h"

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdlib>
#include <utility>

namespace coppice::robot::processes {
namespace {

constexpr Duration kDeadline = std::chrono::seconds(2);

XmlRpc::XmlRpcValue ToValue(const std::string& text) {
  if (text == "true" || text == "false") return XmlRpc::XmlRpcValue(text == "true");
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' ? XmlRpc::XmlRpcValue(number) : XmlRpc::XmlRpcValue(text);
}

}  // namespace

Outcome SetParameters(const NodeAddress& master,
                      const std::map<std::string, std::string>& parameters) {
  for (const auto& [name, text] : parameters) {
    XmlRpc::XmlRpcValue request;
    request[0] = "/supervisor";
    request[1] = "/" + name;
    request[2] = ToValue(text);
    if (!CallMaster(master, "setParam", request, kDeadline)) {
      return Problem{"the ROS master does not take the parameter " + name};
    }
  }
  return {};
}

ParameterLauncher::ParameterLauncher(ProcessLauncher& next, NodeAddress master,
                                     std::map<std::string, std::string> parameters)
    : next_(next), master_(std::move(master)), parameters_(std::move(parameters)) {}

Expected<int> ParameterLauncher::Start(const ProcessConfig& config) {
  const Outcome set = SetParameters(master_, parameters_);
  if (!set) return Problem{set.problem()};
  return next_.Start(config);
}

}  // namespace coppice::robot::processes
