// `coppice live --json`: what a robot does as one JSON object per line, for scripts.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_JSON_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_JSON_H_

#include <ostream>
#include <string>
#include <vector>

#include "bt_core/frames/run_follower.h"
#include "bt_core/live/client/client.h"

namespace coppice {

/// The history as in event_json.h; and objects of the types connection, stopped, resumed, replaced,
/// refused, foreign_hooks.
class LiveJsonPrinter {
 public:
  explicit LiveJsonPrinter(std::ostream& out) : out_(out) {}

  void Print(const LiveConnection& connection);
  void Print(const TreeDescription& tree);
  void Print(const HistoryState& state);
  void Print(const TickEvents& events);
  void Print(const HistoryGap& gap);
  void Print(const HistoryNote& note);
  void Print(const HistoryEnd& end);
  void Print(const LiveNotice& notice);
  void Print(const std::vector<ForeignHook>& hooks);

 private:
  void PrintLine(const std::string& json) { out_ << json << std::endl; }

  std::ostream& out_;
  RunFollower run_;
  bool has_state_ = false;  // of this tree; keyframes say nothing new
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_JSON_H_
