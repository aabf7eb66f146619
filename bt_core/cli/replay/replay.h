// `coppice replay`, `coppice stats` and `coppice convert`: what can be made of a recorded run.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_REPLAY_H_
#define COPPICE_BT_CORE_CLI_REPLAY_REPLAY_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice {

const Command& ReplayCommand();
const Command& StatsCommand();
const Command& ConvertCommand();

/// Of the three: what a run may take, and that in bytes.
CommandOption MemoryOption();
std::optional<std::size_t> MemoryOf(const Options& options);

/// `coppice replay FILE`: in a terminal, a view to go back and forth in the run; else everything
/// that happened, tick by tick. With --at, --tick, --why, --why-not, --verify or --diff the answer
/// to that. docs/replay.md is the manual. Returns 0; 1 if something is missing in the record, or
/// the answer is no; 2 for wrong usage or a file that cannot be read.
int RunReplay(const std::vector<std::string>& arguments);

/// `coppice stats FILE [--sort tree|ticks|time|flips] [--json]`: figures per node.
int RunStats(const std::vector<std::string>& arguments);

/// `coppice convert IN OUT`: between formats, which the endings of the names say.
int RunConvert(const std::vector<std::string>& arguments);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_REPLAY_H_
