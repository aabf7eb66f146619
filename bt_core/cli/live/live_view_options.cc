#include <algorithm>

#include "bt_core/cli/live/live_view.h"

namespace coppice {
namespace {

constexpr double kLongestWait = 86400;  // s: a day

}  // namespace

std::vector<CommandOption> LiveViewOptions() {
  return {
      CommandOption::Flag("--live",
                          "others may watch and debug it: coppice live, the editor, Groot2"),
      CommandOption::Whole("--live-port", "N", 0, 65534, "where; else 1667; 0 takes a free one"),
      CommandOption::Text("--live-address", "A",
                          "not only on this computer; needs a token in COPPICE_LIVE_TOKEN"),
      CommandOption::Flag("--announce",
                          "editors in the network find it (multicast DNS); else nobody is told"),
      CommandOption::Flag("--live-read-only", "they may watch, not control"),
      CommandOption::Flag("--web", "also in a browser, with the editor"),
      CommandOption::Whole("--web-port", "N", 0, 65535, "where; else 8667; 0 takes a free one"),
      CommandOption::Text("--web-folder", "FOLDER", "where the files of the editor's page lie"),
      CommandOption::Whole("--wait-for-client", "SECONDS", 0, kLongestWait,
                           "how long the first tick waits for one that says continue")};
}

bool WantsLiveView(const Options& options) {
  const std::vector<CommandOption> known = LiveViewOptions();
  return std::any_of(known.begin(), known.end(),
                     [&options](const CommandOption& option) { return options.Has(option.name); });
}

}  // namespace coppice
