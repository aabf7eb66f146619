// A log of BehaviorTree.CPP as a run: statuses only, since that is all that is in it.
#ifndef COPPICE_BT_CORE_ANALYSIS_FORMATS_IMPORT_BTLOG_H_
#define COPPICE_BT_CORE_ANALYSIS_FORMATS_IMPORT_BTLOG_H_

#include <cstddef>
#include <optional>
#include <string>

#include "bt_core/analysis/recording.h"

namespace coppice {

/// A day's log; a longer file has no end.
inline constexpr std::size_t kLongestBtlog = std::size_t{1} << 30;  // bytes

/// The bytes of a .btlog. Ticks are not in it: transitions of which each is at most a millisecond
/// behind the one before it count as one. Nothing is returned if the log or the tree in it cannot
/// be understood.
std::optional<Recording> FromBtlog(const std::string& bytes, const std::string& file,
                                   Diagnostics& diagnostics);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_FORMATS_IMPORT_BTLOG_H_
