// About how much memory the parts of a history take, for those who keep some of it and have limits.
#ifndef COPPICE_BT_CORE_FRAMES_HISTORY_SIZE_H_
#define COPPICE_BT_CORE_FRAMES_HISTORY_SIZE_H_

#include <cstddef>

#include "bt_core/frames/history.h"

namespace coppice {

/// Bytes, without those of the allocator.
std::size_t BytesOf(const TreeDescription& tree);
std::size_t BytesOf(const HistoryState& state);
std::size_t BytesOf(const HistoryNote& note);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_FRAMES_HISTORY_SIZE_H_
