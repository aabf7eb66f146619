// What the demonstration is asked for on its command line.
#ifndef COPPICE_ROBOT_APP_APP_DEMO_SETTINGS_H_
#define COPPICE_ROBOT_APP_APP_DEMO_SETTINGS_H_

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice::robot {

struct DemoSettings {
  std::optional<int> exit;  ///< as in Options
  std::string rounds, stops, speed, seed;
  std::string live_port;           ///< of the application; the monitor's is two higher
  bool editor = true;              ///< attach the editor
  bool perception = false;         ///< look for people: in real time or slower
  std::filesystem::path folder;    ///< everything of this run
  std::filesystem::path programs;  ///< build/bin
  std::filesystem::path source;    ///< the project, or what is installed of it
};

const Command& DemoCommand();

DemoSettings ReadDemoSettings(const std::vector<std::string>& arguments);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_DEMO_SETTINGS_H_
