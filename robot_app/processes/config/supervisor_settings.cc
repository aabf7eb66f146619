#include "robot_app/processes/config/supervisor_settings.h"

#include <filesystem>
#include <iostream>

#include "bt_core/base/command_line.h"

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

constexpr char kUsage[] =
    "coppice-supervisor --config FILE [--port N] [--port-file FILE] [--logs FOLDER]\n"
    "                   [--state FILE] [--address IP] [--configuration NAME]\n"
    "                   [--set NAME=VALUE]...\n"
    "  --port           of the ROS master: default 11311, 0 takes a free one\n"
    "  --port-file      gets the port as text when the master answers\n"
    "  --logs           default ./logs\n"
    "  --state          what it remembers across its own restart; default: in the logs folder\n"
    "  --address        of this computer for nodes on other hosts; default: ROS_IP, 127.0.0.1\n"
    "  --configuration  to begin with; default: the file's\n"
    "  --set            variable of the file; bin, config and record have a value";

// Takes "--set NAME=VALUE" out of the arguments; they may come several times.
bool TakeVariables(std::vector<std::string>& arguments, Variables& variables) {
  std::vector<std::string> others;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] != "--set") {
      others.push_back(arguments[i]);
      continue;
    }
    const std::string pair = ++i < arguments.size() ? arguments[i] : "";
    const std::size_t equals = pair.find('=');
    if (equals == 0 || equals == std::string::npos) {
      std::cerr << "coppice-supervisor: --set needs NAME=VALUE, got \"" << pair << "\"\n";
      return false;
    }
    variables[pair.substr(0, equals)] = pair.substr(equals + 1);
  }
  arguments = others;
  return true;
}

}  // namespace

std::optional<SupervisorSettings> ReadSupervisorSettings(std::vector<std::string> arguments,
                                                         const std::string& bin) {
  SupervisorSettings settings;
  settings.variables["bin"] = bin;
  if (!TakeVariables(arguments, settings.variables)) return std::nullopt;
  const auto options = ParseOptions(
      arguments,
      {"--config", "--port", "--port-file", "--logs", "--state", "--address", "--configuration"},
      {}, kUsage);
  if (!options) return std::nullopt;
  settings.config = options->Get("--config");
  const auto port = options->GetNumber("--port").value_or(options->Has("--port") ? -1 : 11311);
  if (settings.config.empty() || port < 0 || port > 65535 || !options->files.empty()) {
    std::cerr << "usage: " << kUsage << "\n";
    return std::nullopt;
  }
  settings.port = static_cast<int>(port);
  settings.address = options->Get("--address");
  settings.port_file = options->Get("--port-file");
  settings.logs = fs::absolute(options->Get("--logs", "logs"));
  settings.state = fs::absolute(options->Get("--state", settings.logs + "/supervisor.json"));
  settings.configuration = options->Get("--configuration");
  settings.variables.emplace("config", fs::absolute(settings.config).parent_path());
  std::string& record = settings.variables.emplace("record", settings.logs).first->second;
  record = fs::absolute(record / fs::path(".")).lexically_normal().parent_path();
  return settings;
}

}  // namespace coppice::robot
