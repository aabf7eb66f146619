// Answers the requests of the Groot2 protocol for one tree.
#ifndef COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_SERVICE_H_
#define COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_SERVICE_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/live/groot2/groot2_hooks.h"
#include "bt_core/live/groot2/groot2_protocol.h"
#include "bt_core/live/server/live_tree.h"

namespace coppice {

class Groot2Service {
 public:
  /// A client that was silent for `deadline` has its hooks disabled.
  Groot2Service(std::shared_ptr<LiveTree> tree, Duration deadline);

  /// `may_control`: the client has the role for it. `now`: in real time.
  groot2::Parts Answer(const groot2::Request& request, bool may_control, Duration now);

  /// Disables all hooks when nobody asks any more.
  void Expire(Duration now);

  /// What to publish when the debugger tells of this; empty if it does not concern the protocol.
  groot2::Parts Notification(const DebugEvent& event);

  const std::shared_ptr<LiveTree>& tree() const { return tree_; }

 private:
  /// What stands behind the header of a reply, if something does.
  using Payload = std::optional<std::string>;

  void Heed(Duration now);
  Expected<Payload> Serve(const groot2::Request& request);
  static Expected<Payload> Done(const Outcome& outcome);  ///< without a payload
  Expected<Payload> Control(const groot2::Request& request);
  Payload ToggleRecording(std::string_view what);
  Expected<Payload> FullTree();
  std::string Statuses() const;
  std::string Boards(std::string_view names) const;

  const std::shared_ptr<LiveTree> tree_;
  const Duration deadline_;
  Groot2Hooks hooks_;
  Duration last_request_{0};
  bool silenced_ = false;  // the hooks are disabled because nobody asked
  std::uint32_t notifications_ = 0;
  std::shared_ptr<const Program> written_program_;  // as full_tree_
  std::optional<std::string> full_tree_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_LIVE_GROOT2_GROOT2_SERVICE_H_
