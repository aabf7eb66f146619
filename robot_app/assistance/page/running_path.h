// What a tree is doing now, in a few words, from its live socket (bt_core/live). While the tree is
// not there, it is waited for.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_PAGE_RUNNING_PATH_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_PAGE_RUNNING_PATH_H_

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bt_core/frames/run_follower.h"
#include "bt_core/live/client/client.h"

namespace coppice::robot::assistance {

/// The names of the nodes that run, from the root to the leaf: of each node the first child that
/// runs; empty if nothing runs.
std::vector<std::string> RunningPath(const TreeDescription& tree,
                                     const std::vector<Status>& statuses);

class RunningPathFollower : public LiveListener {
 public:
  /// `endpoint` as of LiveClient; the token comes from the environment (TokenFromEnvironment).
  explicit RunningPathFollower(const std::string& endpoint);
  ~RunningPathFollower() override;

  struct View {
    bool is_live = false;
    std::vector<std::string> path;
  };
  /// Any thread.
  View Now() const;

  void OnConnection(const LiveConnection& connection) override;
  void OnTree(const TreeDescription& tree) override;
  void OnState(const HistoryState& state) override;
  void OnTick(const TickEvents& events) override;

 private:
  mutable std::mutex mutex_;  // for all but the client
  bool is_live_ = false;
  RunFollower run_;
  std::unique_ptr<LiveClient> client_;
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_PAGE_RUNNING_PATH_H_
