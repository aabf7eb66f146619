// coppice-processes: what the process supervisor says, and what a person may ask of it.
#include <coppice_msgs/RestartProcess.h>
#include <coppice_msgs/SetConfiguration.h>
#include <coppice_msgs/SetSite.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <unistd.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>

#include "bt_core/base/command_line.h"
#include "robot_app/common/find_master.h"
#include "robot_app/common/node_probe.h"
#include "robot_app/common/service_call.h"
#include "robot_app/processes/processes_view.h"

namespace coppice::robot::processes {
namespace {

const Command& ProcessesCommand() {
  static const Command command{
      "coppice processes",
      "what the process supervisor says, and may be asked",
      {"[REQUEST]", 0, 2},
      R"(Without a request: the robot's programs.
  restart NAME        a program, node or group; all: the whole stack
  reset NAME          it is repaired: forget its restarts; or all
  configuration NAME  change it, and hold it by hand
  release             let the trees decide about it again
  site NAME           the robot was brought there: all begins anew with what belongs to it
Ends with 0 if all is well or the request was granted, 1 if not, 2 for wrong usage, 3 if nobody
answers.)",
      {CommandOption::Flag("--watch", "until it is interrupted"),
       CommandOption::Flag("--json", "as JSON"),
       CommandOption::Text("--master", "URI", "ROS_MASTER_URI of the robot"),
       CommandOption::Real("--timeout", "SECONDS", 0.001, 1e6,
                           "for an answer of the supervisor; else 5")}};
  return command;
}

enum Exit { kWell = 0, kNotWell = 1, kNobody = 3 };

volatile std::sig_atomic_t g_stop = 0;

int Usage() { return RefuseOptions(ProcessesCommand(), "there is no such request"); }

int Nobody() {
  std::cerr << "coppice processes: no process supervisor answers at " << ros::master::getURI()
            << "\n";
  return kNobody;
}

int Report(bool ok, const std::string& message) {
  (ok ? std::cout : std::cerr) << message << std::endl;
  return ok ? kWell : kNotWell;
}

template <class Service>
bool Call(const std::string& name, Service& service, double timeout) {
  return ros::service::waitForService(name, ros::Duration(timeout)) &&
         CallService(name, service,
                     std::chrono::duration_cast<Duration>(std::chrono::duration<double>(timeout)));
}

int Request(const std::vector<std::string>& words, double timeout) {
  const std::string& verb = words[0];
  if (verb == "release" && words.size() == 1) {
    std_srvs::Trigger release;
    if (!Call("/supervisor/release", release, timeout)) return Nobody();
    return Report(release.response.success, release.response.message);
  }
  if (words.size() != 2) return Usage();
  if (verb == "configuration") {
    coppice_msgs::SetConfiguration configure;
    configure.request.configuration = words[1];
    configure.request.manual = true;
    if (!Call("/supervisor/set_configuration", configure, timeout)) return Nobody();
    return Report(configure.response.ok, configure.response.message);
  }
  if (verb == "site") {
    coppice_msgs::SetSite move;
    move.request.site = words[1];
    move.request.manual = true;
    if (!Call("/supervisor/set_site", move, timeout)) return Nobody();
    return Report(move.response.ok, move.response.message);
  }
  if (verb != "restart" && verb != "reset") return Usage();
  coppice_msgs::RestartProcess restart;
  restart.request.name = words[1];
  if (!Call("/supervisor/" + verb, restart, timeout)) return Nobody();
  return Report(restart.response.ok, restart.response.message);
}

// Shows what comes: once, or until it is interrupted.
int Show(bool watch, bool as_json, double timeout) {
  WallClock clock;
  ros::NodeHandle handle;
  std::optional<coppice_msgs::ProcessStates> states;
  const ros::Subscriber subscriber = handle.subscribe<coppice_msgs::ProcessStates>(
      "/processes", 1, [&](const coppice_msgs::ProcessStates::ConstPtr& message) {
        states = *message;
        if (watch && !as_json && isatty(STDOUT_FILENO)) std::cout << "\033[H\033[2J";
        std::cout << (as_json ? ToJson(*states) : ToTable(*states, clock.Now())) << std::flush;
      });
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(timeout);
  while (!g_stop && (watch || !states)) {
    if (!states && ros::WallTime::now() > deadline) return Nobody();
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.05));
  }
  return states && IsAsItShouldBe(*states) ? kWell : kNotWell;
}

// Who answers in the supervisor's or the master's place may say what roscpp does not expect.
int AskOrShow(const Options& options, double timeout) {
  try {
    ros::start();
    return options.files.empty() ? Show(options.Has("--watch"), options.Has("--json"), timeout)
                                 : Request(options.files, timeout);
  } catch (const XmlRpc::XmlRpcException&) {
    return Nobody();
  } catch (const std::exception&) {
    return Nobody();
  }
}

int Main(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(ProcessesCommand(), arguments);
  if (options.exit) return *options.exit;
  const double timeout = options.Real("--timeout", 5);
  if (options.Has("--master")) {
    const std::string uri = options.Get("--master");
    if (!ParseUri(uri)) {  // roscpp ends the program for it
      return RefuseOptions(ProcessesCommand(), "--master: expected http://HOST:PORT, not " + uri);
    }
    setenv("ROS_MASTER_URI", uri.c_str(), 1);
  }
  setenv("ROS_MASTER_URI", "http://127.0.0.1:11311", 0);

  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { g_stop = 1; });
  int no_arguments = 0;
  ros::init(no_arguments, nullptr, "processes",
            ros::init_options::AnonymousName | ros::init_options::NoSigintHandler |
                ros::init_options::NoRosout);
  // A master that ends from now on is not waited for for ever either.
  ros::master::setRetryTimeout(ros::WallDuration(timeout));
  if (!HasMaster()) return Nobody();
  ros::Time::init();
  const bool asks = !options.files.empty();
  if (asks && (options.Has("--watch") || options.Has("--json"))) return Usage();
  const int status = AskOrShow(options, timeout);
  ros::shutdown();
  return status;
}

}  // namespace
}  // namespace coppice::robot::processes

int main(int argc, char** argv) {
  return coppice::FinishOutput(coppice::robot::processes::Main({argv + 1, argv + argc}));
}
