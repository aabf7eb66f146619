// What kept a node from being ticked; a part of why.h.
#ifndef COPPICE_BT_CORE_ANALYSIS_WHY_WHY_NOT_H_
#define COPPICE_BT_CORE_ANALYSIS_WHY_WHY_NOT_H_

#include "bt_core/analysis/why/tick_story.h"

namespace coppice {

/// Of a node without a step in the walk.
WhyNot WhyNotOf(const TickStory& story, NodeIndex node);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ANALYSIS_WHY_WHY_NOT_H_
