#include "robot_app/app/demo_settings.h"

#include <ctime>
#include <iomanip>
#include <sstream>

#include "bt_core/base/command_line.h"

namespace coppice::robot {
namespace {

constexpr char kUsage[] =
    "coppice-demo [--rounds N] [--stops N] [--speed FACTOR] [--seed N] [--run FOLDER] [--live-port "
    "N]\n"
    "             [--no-editor]\n"
    "  Defaults: 2 rounds of 3 stops, 5 times real time, runs/<date and time>, live sockets from "
    "1667 on.";

std::string Timestamp() {
  const std::time_t now = std::time(nullptr);
  std::ostringstream text;
  text << std::put_time(std::localtime(&now), "%Y-%m-%d_%H-%M-%S");
  return text.str();
}

}  // namespace

std::optional<DemoSettings> ReadDemoSettings(const std::vector<std::string>& arguments) {
  const auto options =
      ParseOptions(arguments, {"--rounds", "--stops", "--speed", "--seed", "--run", "--live-port"},
                   {"--no-editor"}, kUsage);
  if (!options) return std::nullopt;
  DemoSettings settings;
  settings.rounds = options->Get("--rounds", "2");
  settings.stops = options->Get("--stops", "3");
  settings.speed = options->Get("--speed", "5");
  settings.seed = options->Get("--seed", "1");
  settings.live_port = options->Get("--live-port", "1667");
  settings.editor = !options->Has("--no-editor");
  settings.programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  settings.source = COPPICE_SOURCE_DIR;
  settings.folder = std::filesystem::absolute(options->Get("--run", "runs/" + Timestamp()));
  return settings;
}

}  // namespace coppice::robot
