// A record on the disk as a run in memory.
#ifndef COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
#define COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// That a run takes in memory, about [bytes]. Ticks in which nothing happens take nearly nothing on
/// the disk, so some kilobytes of it may be millions of them.
inline constexpr std::size_t kMostRunBytes = std::size_t{1} << 30;

/// Reads a record and the files that continue it. Nothing is returned if there is no tree in it, or
/// if the run takes more than `most_bytes`; damaged places are left out with a warning.
std::optional<Recording> LoadRecording(const std::string& path, Diagnostics& diagnostics,
                                       std::size_t most_bytes = kMostRunBytes);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
