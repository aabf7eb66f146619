#include "robot_app/processes/config/supervisor_settings.h"

#include <filesystem>

namespace coppice::robot::processes {
namespace {

namespace fs = std::filesystem;

// "NAME=VALUE".
bool AddVariable(const std::string& text, Variables& variables) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) return false;
  variables[text.substr(0, equals)] = text.substr(equals + 1);
  return true;
}

}  // namespace

const Command& SupervisorCommand() {
  static const Command command{
      "coppice-supervisor",
      "start a robot's programs and keep track of them",
      {},
      "",
      {CommandOption::Text("--config", "FILE", "robot.yaml").Needed(),
       CommandOption::Whole("--port", "N", 0, 65535,
                            "of the ROS master; else 11311, 0 takes a free one"),
       CommandOption::Text("--port-file", "FILE", "gets the port as text when the master answers"),
       CommandOption::Text("--logs", "FOLDER", "else ./logs"),
       CommandOption::Text("--state", "FILE",
                           "what it remembers across its own restart; else in the logs folder"),
       CommandOption::Text("--address", "IP",
                           "of this computer for nodes on other hosts; else ROS_IP, 127.0.0.1"),
       CommandOption::Text("--configuration", "NAME", "to begin with; else the file's"),
       CommandOption::Text("--set", "NAME=VALUE",
                           "variable of the file, which may be given several times; bin, config "
                           "and record have a value")}};
  return command;
}

SupervisorSettings ReadSupervisorSettings(const std::vector<std::string>& arguments,
                                          const std::string& bin) {
  const Options options = ParseOptions(SupervisorCommand(), arguments);
  SupervisorSettings settings;
  settings.exit = options.exit;
  if (options.exit) return settings;
  settings.variables["bin"] = bin;
  for (const std::string& text : options.GetAll("--set")) {
    if (AddVariable(text, settings.variables)) continue;
    settings.exit =
        RefuseOptions(SupervisorCommand(), "--set: expected NAME=VALUE, not \"" + text + "\"");
  }
  for (const char* const name : {"--config", "--logs", "--state"}) {
    if (!options.Has(name) || !options.Get(name).empty()) continue;
    settings.exit = RefuseOptions(SupervisorCommand(), std::string(name) + ": expected a name");
  }
  if (settings.exit) return settings;
  settings.config = options.Get("--config");
  settings.port = static_cast<int>(options.Whole("--port", settings.port));
  settings.address = options.Get("--address");
  settings.port_file = options.Get("--port-file");
  settings.logs = fs::absolute(options.Get("--logs", "logs"));
  settings.state = fs::absolute(options.Get("--state", settings.logs + "/supervisor.json"));
  settings.configuration = options.Get("--configuration");
  settings.variables.emplace("config", fs::absolute(settings.config).parent_path());
  std::string& record = settings.variables.emplace("record", settings.logs).first->second;
  record = fs::absolute(record / fs::path(".")).lexically_normal().parent_path();
  return settings;
}

}  // namespace coppice::robot::processes
