// `coppice replay`: what happened in a recorded run, for people and for scripts.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_H_
#define COPPICE_BT_CORE_CLI_REPLAY_H_

#include <string>
#include <vector>

namespace coppice {

/// `coppice replay FILE [--json] [--node PATTERN] [--from T] [--to T]`. Prints the header, every
/// tick in which something happened and a summary; with --json one object per line. PATTERN is a
/// shell pattern for node paths; then only changes and messages of those nodes are shown. T is in
/// seconds since the start of the record. Returns 0; 1 if the record is damaged, cut off or has
/// gaps, and the output says where; 2 for wrong usage or a file that cannot be read.
int RunReplay(const std::vector<std::string>& arguments);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_H_
