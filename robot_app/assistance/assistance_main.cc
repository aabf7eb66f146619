// coppice-assistance: the node /assistance, the robot's way to its human supervisors.
#include <coppice_msgs/AnswerHelp.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "robot_app/assistance/assistance.h"
#include "robot_app/assistance/assistance_node.h"
#include "robot_app/assistance/call.h"
#include "robot_app/assistance/page/page_node.h"
#include "robot_app/common/find_master.h"
#include "robot_app/common/shipped.h"

namespace coppice::robot::assistance {
namespace {

const Command& AssistanceCommand() {
  static const Command command{
      "coppice-assistance",
      "ask the robot's human supervisors for help",
      {},
      "Asks the robot's human supervisors for help, as the ROS node /assistance, and serves their "
      "page.",
      {CommandOption::Text("--config", "FILE",
                           "who the supervisors are, and by what they are asked"),
       CommandOption::Text("--state", "FILE",
                           "where open requests outlive a restart of the program"),
       CommandOption::Whole("--page-port", "N", 0, 65535,
                            "of the page, 0 = none; else as the configuration says"),
       CommandOption::Text("--page", "FOLDER", "of its files; else that of the sources"),
       CommandOption::Whole("--live-port", "N", 0, 65533,
                            "of the application tree, as of coppice-robot; else 1667, 0 = none"),
       CommandOption::Text("--call", "TEXT",
                           "sends one message to the first supervisor who can be reached, without "
                           "ROS, and ends"),
       CommandOption::Text("--subject", "NAME", "of that message; else robot"),
       CommandOption::OneOf("--answer", {"fixed", "not_fixed"},
                            "answers a request of the running node, and ends"),
       CommandOption::Whole("--request", "ID", 0, UINT32_MAX, "which; else the oldest open one"),
       CommandOption::Text("--by", "NAME", "who answers; else console")}};
  return command;
}

std::atomic<bool> stop_requested{false};
void RequestStop(int) { stop_requested = true; }

// Warnings are printed; nothing, if there are errors.
std::optional<AssistanceConfig> Load(const Options& options) {
  if (!options.Has("--config")) {
    RefuseOptions(AssistanceCommand(), "--config is required");
    return std::nullopt;
  }
  Diagnostics diagnostics;
  AssistanceConfig config =
      LoadAssistanceConfig(options.Get("--config"), ProcessEnvironment, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return std::nullopt;
  config.page.port = static_cast<std::uint16_t>(options.Whole("--page-port", config.page.port));
  return config;
}

int Call(const Options& options) {
  const std::optional<AssistanceConfig> config = Load(options);
  if (!config) return 2;
  std::string problems;
  const bool ok = CallSupervisors(*config, MakeChannels(*config), options.Get("--subject", "robot"),
                                  options.Get("--call"), problems);
  std::cerr << problems;
  return ok ? 0 : 1;
}

int Answer(const Options& options) {
  coppice_msgs::AnswerHelp service;
  service.request.id = static_cast<std::uint32_t>(options.Whole("--request", 0));
  service.request.by = options.Get("--by", "console");
  service.request.fixed = options.Get("--answer") == "fixed";
  if (!ros::service::call("/assistance/answer", service)) {
    std::cerr << "coppice-assistance: the node /assistance does not answer\n";
    return 1;
  }
  std::cout << service.response.message << "\n";
  return service.response.ok ? 0 : 1;
}

std::vector<PageNode::Tree> TreesOf(const Options& options) {
  const std::int64_t port = options.Whole("--live-port", 1667);
  if (port <= 0) return {};
  return {{"application", "127.0.0.1:" + std::to_string(port)},
          {"monitor", "127.0.0.1:" + std::to_string(port + 2)}};
}

// Null, with a word in the log, if there is to be none or its port is taken: messages go out all
// the same.
std::unique_ptr<PageNode> OpenPage(ros::NodeHandle& node, const AssistanceConfig& config,
                                   const Options& options, Assistance& assistance,
                                   const Clock& clock) {
  if (config.page.port == 0) return nullptr;
  try {
    auto page = std::make_unique<PageNode>(node, config,
                                           options.Get("--page", Shipped(COPPICE_PAGE_FOLDER)),
                                           TreesOf(options), assistance, clock);
    const std::string& address = config.page.address == "*" ? "127.0.0.1" : config.page.address;
    const std::string here = "http://" + address + ":" + std::to_string(page->port());
    assistance.set_page_url(config.page.public_url.empty() ? here : config.page.public_url);
    ROS_INFO_STREAM("the supervisor page is served at " << here);
    return page;
  } catch (const std::runtime_error& error) {
    ROS_ERROR_STREAM(error.what());
    return nullptr;
  }
}

void Serve(const AssistanceConfig& config, const Options& options) {
  const WallClock clock;
  ros::NodeHandle node;
  Assistance assistance(config, MakeChannels(config), options.Get("--state"), clock.Now());
  assistance.Listen(MakeListeners(config));
  AssistanceNode services(node, assistance.desk(), clock);
  const std::unique_ptr<PageNode> page = OpenPage(node, config, options, assistance, clock);
  while (ros::ok() && !stop_requested) {
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.02));
    if (page) page->Step();
    for (const std::string& problem : assistance.Step(clock.Now())) {
      ROS_WARN_STREAM_THROTTLE(1, problem);
    }
    services.Publish();
  }
}

int Main(int argc, char** argv) {
  const bool is_answer = argc > 1 && std::string(argv[1]) == "--answer";
  ros::init(
      argc, argv, "assistance",
      ros::init_options::NoSigintHandler | (is_answer ? ros::init_options::AnonymousName : 0));
  const Options options = ParseOptions(AssistanceCommand(), {argv + 1, argv + argc});
  if (options.exit) return *options.exit;
  if (options.Has("--call")) return Call(options);
  if (options.Has("--answer")) return FindMaster("coppice-assistance") ? Answer(options) : 2;
  const std::optional<AssistanceConfig> config = Load(options);
  if (!config || !FindMaster("coppice-assistance")) return 2;
  std::signal(SIGINT, RequestStop);
  std::signal(SIGTERM, RequestStop);
  try {
    Serve(*config, options);
  } catch (const std::exception& error) {
    std::cerr << "coppice-assistance: " << error.what() << "\n";
    return 2;
  }
  ros::shutdown();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::assistance

int main(int argc, char** argv) { return coppice::robot::assistance::Main(argc, argv); }
