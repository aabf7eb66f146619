// Runs in the formats of other tools.
//
//   const std::string json = ToChromeTrace(run);    // opens in ui.perfetto.dev
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_EXPORT_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_EXPORT_H_

#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// Chrome's trace event format (JSON), which Perfetto reads: a slice for every tick and for every
/// time that a node did not leave RUNNING, an instant for every other result, a counter for every
/// key with numbers.
std::string ToChromeTrace(const Recording& run);

/// Comma separated values (RFC 4180) with a header line: time, tick, kind (change, write, delivery,
/// message, exception, injected, gap, note), subject, from, to, by.
std::string ToCsv(const Recording& run);

/// The log of BehaviorTree.CPP's FileLogger2, version 1, of the first tree of the run. Nothing is
/// returned if it has more than 65535 nodes, which that format cannot number.
std::optional<std::string> ToBtlog(const Recording& run, Diagnostics& diagnostics);

/// A bag of ROS 1, format 2.0: messages of type std_msgs/String on the topics
/// /coppice/tree (its XML), /coppice/ticks and /coppice/changes, the latter JSON objects.
/// Nothing is returned if it would be larger than a chunk of a bag can be.
std::optional<std::string> ToRosbag(const Recording& run, Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_EXPORT_H_
