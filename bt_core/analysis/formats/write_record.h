// A run in memory as the bytes of a record.
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_WRITE_RECORD_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_WRITE_RECORD_H_

#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// docs/record_format.md; with states to begin reading at every some hundred kilobytes.
std::string ToRecord(const Recording& run);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_WRITE_RECORD_H_
