// The history of a run as JSON, one object per event. `coppice live --json` and `coppice replay
// --json` print these, so the same run gives the same lines; docs/live.md describes them.
#ifndef COPPICE_BT_CORE_CLI_EVENT_JSON_H_
#define COPPICE_BT_CORE_CLI_EVENT_JSON_H_

#include <string>

#include "bt_core/analysis/told_tick.h"

namespace coppice {

std::string EventJson(const TreeDescription& tree);
std::string EventJson(const TreeDescription& tree, const HistoryState& state);
std::string EventJson(const ToldTick& tick);
std::string EventJson(const HistoryGap& gap);
std::string EventJson(const HistoryNote& note);
std::string EventJson(const HistoryEnd& end);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_EVENT_JSON_H_
