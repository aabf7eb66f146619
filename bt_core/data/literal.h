// The value of a text of which nobody says what type it is.
#ifndef COPPICE_BT_CORE_DATA_LITERAL_H_
#define COPPICE_BT_CORE_DATA_LITERAL_H_

#include <string_view>

#include "bt_core/data/value.h"

namespace coppice {

/// A whole number is an int64, any other number a double, and everything else a string. So is what
/// a number would not give back: "00042" stays "00042".
Value GuessValue(std::string_view text);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_DATA_LITERAL_H_
