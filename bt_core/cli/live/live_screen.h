// A scene of `coppice live` as lines of text.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_SCREEN_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_SCREEN_H_

#include <cstddef>
#include <string>
#include <vector>

#include "bt_core/cli/live/live_scene.h"

namespace coppice {

struct ScreenOptions {
  std::string endpoint;
  bool shows_board = false;
  bool has_colours = false;  ///< escape sequences of ECMA-48
  std::size_t rows = 0;      ///< 0: as many as it takes
  std::size_t columns = 0;
};

/// What is active is marked with '>', and in bold; what is idle shows in brackets what it was last.
/// If there are more nodes than rows, what is idle with its parent is left out first.
std::vector<std::string> DrawScene(const LiveScene& scene, const ScreenOptions& options);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_SCREEN_H_
