// What differs between two runs, in words for people who look at the first one.
#ifndef COPPICE_BT_CORE_ANALYSIS_DIFFERENCE_TEXT_H_
#define COPPICE_BT_CORE_ANALYSIS_DIFFERENCE_TEXT_H_

#include <string>

#include "bt_core/analysis/compare.h"

namespace coppice {

/// One sentence: `In tick 12, "Drive" returned SUCCESS here but FAILURE there; it differs in 3
/// ticks`.
std::string Sentence(const RunDifference& difference);

/// Likewise: `The runs part in tick 12: "Drive" returned SUCCESS here, but FAILURE there`.
std::string Sentence(const PartingPoint& parting);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_DIFFERENCE_TEXT_H_
