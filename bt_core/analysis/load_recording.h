// A record on the disk as a run in memory.
#ifndef COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
#define COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"
#include "bt_core/record/record_reader.h"

namespace coppice {

/// That a run may take in memory, about [bytes].
inline constexpr std::size_t kMostRunBytes = std::size_t{1} << 30;

/// That the run of a record may take, about [bytes]. Ticks in which nothing happens take nearly
/// nothing on the disk, so some kilobytes of it may be millions of them. Of what Coppice recorded
/// itself a run takes at most some 200 times its files.
std::size_t MostRunBytes(const RecordReader& record);

/// Reads a record and the files that continue it. Nothing is returned if there is no tree in it, or
/// if the run takes more than `most_bytes` (without it, MostRunBytes); damaged places are left out
/// with a warning.
std::optional<Recording> LoadRecording(const std::string& path, Diagnostics& diagnostics,
                                       std::optional<std::size_t> most_bytes = std::nullopt);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_LOAD_RECORDING_H_
