// Recorded values as values of a running tree.
#ifndef COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_VALUE_H_
#define COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_VALUE_H_

#include <string_view>

#include "bt_core/data/value.h"

namespace coppice {

/// A value of the type; empty if the bytes are none of it. Without a type, one of the form of the
/// bytes.
Value PlayedValue(std::string_view bytes, const Type* type);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_PLAY_PLAYED_VALUE_H_
