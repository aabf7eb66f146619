// A record on the disk as a run in memory.
#ifndef COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
#define COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_

#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// Reads a record and the files that continue it. Nothing is returned if there is no tree in it;
/// damaged places are left out with a warning.
std::optional<Recording> LoadRecording(const std::string& path, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
