// `coppice replay FILE --scenario OUT`: a recorded run as a test.
#ifndef COPPICE_BT_CORE_CLI_REPLAY_REPLAY_SCENARIO_H_
#define COPPICE_BT_CORE_CLI_REPLAY_REPLAY_SCENARIO_H_

#include <string>

#include "bt_core/analysis/recording.h"
#include "bt_core/base/command_line.h"

namespace coppice {

/// An option in seconds since the start as a time of the record.
Time RecordTime(const Options& options, const std::string& name, Time start);

/// Exit status: 0, 1 if the run cannot be made a test, 2 for wrong options.
int MakeScenario(const Options& options, const Recording& run);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_REPLAY_REPLAY_SCENARIO_H_
