// `coppice run --live`: the options of the live view, and the view.
#ifndef COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_
#define COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_

#include <functional>
#include <memory>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_core/engine/events/event_stream.h"
#include "bt_core/frames/history.h"

namespace coppice {

class LivePublisher;

/// Shared by the programs that run a tree.
std::vector<CommandOption> LiveViewOptions();
/// One of them is given.
bool WantsLiveView(const Options& options);

class LiveView {
 public:
  /// Opens the view if one of the options is given, and prints where it is. The stream must live
  /// longer. Throws std::exception with a text for people if that cannot be. `on_note`: as
  /// LiveTreeOptions::on_note.
  LiveView(EventStream& stream, const Options& options,
           std::function<void(const HistoryNote&)> on_note);
  ~LiveView();
  LiveView(const LiveView&) = delete;
  LiveView& operator=(const LiveView&) = delete;

 private:
  std::unique_ptr<LivePublisher> publisher_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_CLI_LIVE_LIVE_VIEW_H_
