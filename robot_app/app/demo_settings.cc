#include "robot_app/app/demo_settings.h"

#include <ctime>
#include <iomanip>
#include <sstream>

#include "robot_app/common/shipped.h"

namespace coppice::robot {
namespace {

std::string Timestamp() {
  const std::time_t now = std::time(nullptr);
  std::ostringstream text;
  text << std::put_time(std::localtime(&now), "%Y-%m-%d_%H-%M-%S");
  return text.str();
}

}  // namespace

const Command& DemoCommand() {
  static const Command command{
      "coppice-demo",
      "the simulated robot with all that belongs to it",
      {},
      "",
      {CommandOption::Whole("--rounds", "N", -1, 1e9, "patrol rounds; else 2"),
       CommandOption::Whole("--stops", "N", 0, 1e9, "places per round; else 3"),
       CommandOption::Real("--speed", "FACTOR", 0.01, 1000,
                           "times real time; else 5. People are seen up to 1"),
       CommandOption::Whole("--seed", "N", 0, UINT32_MAX, "chooses the places; else 1"),
       CommandOption::Text("--run", "FOLDER", "for logs and records; else runs/<date and time>"),
       CommandOption::Whole("--live-port", "N", 0, 65533, "live sockets from there on; else 1667"),
       CommandOption::Flag("--no-editor", "does not attach the editor")}};
  return command;
}

DemoSettings ReadDemoSettings(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(DemoCommand(), arguments);
  DemoSettings settings;
  settings.exit = options.exit;
  if (options.exit) return settings;
  settings.rounds = options.Get("--rounds", "2");
  settings.stops = options.Get("--stops", "3");
  settings.speed = options.Get("--speed", "5");
  settings.seed = options.Get("--seed", "1");
  settings.live_port = options.Get("--live-port", "1667");
  settings.editor = !options.Has("--no-editor");
  settings.perception = options.Real("--speed", 5) <= 1;
  settings.programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  settings.source = Shipped(COPPICE_SOURCE_DIR);
  const std::string run = options.Get("--run", "runs/" + Timestamp());
  if (run.empty()) settings.exit = RefuseOptions(DemoCommand(), "--run: expected a folder");
  if (!run.empty()) settings.folder = std::filesystem::absolute(run);
  return settings;
}

}  // namespace coppice::robot
