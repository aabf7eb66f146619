// A run in memory as the bytes of a record.
#ifndef COPPICE_BT_CORE_REPLAY_WRITE_RECORD_H_
#define COPPICE_BT_CORE_REPLAY_WRITE_RECORD_H_

#include <string>

#include "bt_core/replay/recording.h"

namespace coppice {

/// docs/record_format.md; with states to begin reading at every some hundred kilobytes.
std::string ToRecord(const Recording& run);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_REPLAY_WRITE_RECORD_H_
