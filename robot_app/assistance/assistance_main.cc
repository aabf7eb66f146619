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

namespace coppice::robot {
namespace {

constexpr char kUsage[] =
    R"(coppice-assistance --config FILE [--state FILE] [--page-port N] [--page FOLDER]
                          [--live-port N]
       coppice-assistance --config FILE --call TEXT [--subject NAME]
       coppice-assistance --answer fixed|not_fixed [--request ID] [--by NAME]
  Asks the robot's human supervisors for help, as the ROS node /assistance, and serves their page.
  --state      where open requests outlive a restart of the program
  --page-port  of the page, 0 = none; default: as the configuration says
  --page       folder of its files; default: that of the sources
  --live-port  of the application tree, as of coppice-robot; default 1667, 0 = none
  --call       sends one message to the first supervisor who can be reached, without ROS, and ends
  --answer     answers a request of the running node (default: the oldest that is open), and ends)";

std::atomic<bool> stop_requested{false};
void RequestStop(int) { stop_requested = true; }

// Warnings are printed; nothing, if there are errors.
std::optional<AssistanceConfig> Load(const Options& options) {
  if (!options.Has("--config")) {
    std::cerr << "--config is missing\nusage: " << kUsage << "\n";
    return std::nullopt;
  }
  Diagnostics diagnostics;
  AssistanceConfig config =
      LoadAssistanceConfig(options.Get("--config"), ProcessEnvironment, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) return std::nullopt;
  if (const auto port = options.GetNumber("--page-port")) {
    config.page.port = static_cast<std::uint16_t>(*port);
  }
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
  const std::string answer = options.Get("--answer");
  if (answer != "fixed" && answer != "not_fixed") {
    std::cerr << "--answer must be fixed or not_fixed\n";
    return 2;
  }
  coppice_msgs::AnswerHelp service;
  service.request.id = static_cast<std::uint32_t>(options.GetNumber("--request").value_or(0));
  service.request.by = options.Get("--by", "console");
  service.request.fixed = answer == "fixed";
  if (!ros::service::call("/assistance/answer", service)) {
    std::cerr << "coppice-assistance: the node /assistance does not answer\n";
    return 1;
  }
  std::cout << service.response.message << "\n";
  return service.response.ok ? 0 : 1;
}

std::vector<PageNode::Tree> TreesOf(const Options& options) {
  const std::int64_t port = options.GetNumber("--live-port").value_or(1667);
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
    auto page = std::make_unique<PageNode>(node, config, options.Get("--page", COPPICE_PAGE_FOLDER),
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

bool FindMaster() {
  if (ros::master::check()) return true;
  std::cerr << "coppice-assistance: no ROS master at " << ros::master::getURI()
            << "; start one with `roscore` or set ROS_MASTER_URI\n";
  return false;
}

int Main(int argc, char** argv) {
  const bool is_answer = argc > 1 && std::string(argv[1]) == "--answer";
  ros::init(
      argc, argv, "assistance",
      ros::init_options::NoSigintHandler | (is_answer ? ros::init_options::AnonymousName : 0));
  const std::optional<Options> options =
      ParseOptions({argv + 1, argv + argc},
                   {"--config", "--state", "--page-port", "--page", "--live-port", "--call",
                    "--subject", "--answer", "--request", "--by"},
                   {}, kUsage);
  if (!options) return 2;
  if (options->Has("--call")) return Call(*options);
  if (options->Has("--answer")) return FindMaster() ? Answer(*options) : 2;
  const std::optional<AssistanceConfig> config = Load(*options);
  if (!config || !FindMaster()) return 2;
  std::signal(SIGINT, RequestStop);
  std::signal(SIGTERM, RequestStop);
  try {
    Serve(*config, *options);
  } catch (const std::exception& error) {
    std::cerr << "coppice-assistance: " << error.what() << "\n";
    return 2;
  }
  ros::shutdown();
  return 0;
}

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) { return coppice::robot::Main(argc, argv); }
