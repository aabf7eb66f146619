// One tree of the robot with everything that belongs to it: executor, thread, live socket, record.
#ifndef COPPICE_ROBOT_APP_APP_TREE_RUNNER_H_
#define COPPICE_ROBOT_APP_APP_TREE_RUNNER_H_

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "bt_core/base/outcome.h"
#include "bt_core/engine/events/event_stream.h"
#include "bt_core/engine/runner.h"
#include "bt_core/live/pictures/live_pictures.h"
#include "bt_core/live/server/live_publisher.h"
#include "bt_core/record/recorder.h"

namespace coppice::robot {

struct TreeRunnerOptions {
  std::string name;  ///< "application", "monitor"; also the name of the record
  std::string
      record_path;  ///< file to record to; if it exists, name.2.coppice and so on. Empty: none
  /// Of the live socket on loopback; it takes this port and the next one. 0: none.
  int live_port = 0;
  /// For those who may stop and change the tree by the live socket; without it nobody may.
  std::string live_token;
  /// What the robot shows to people, for those who watch the tree; null: nothing.
  std::shared_ptr<const LivePictures> pictures;
  /// Gets all events of the tree; must live longer than the runner. Null: none.
  EventListener* listener = nullptr;
  RunOptions run;
};

class TreeRunner {
 public:
  /// Opens socket and record; does not tick yet. A robot runs also without them: see RecordTrouble
  /// and LiveTrouble.
  TreeRunner(std::shared_ptr<const Program> program, Clock& clock, TreeRunnerOptions options);
  ~TreeRunner();  // stops, then halts the tree

  Executor& executor() { return executor_; }

  /// Starts the thread. `on_end` is called on it with the root's last result when the tree has
  /// completed.
  void Start(std::function<void(Status)> on_end);
  void Stop();

  /// Halts the tree; it rests until Resume, and then begins anew. Without effect once the tree has
  /// completed. Return at once; any thread but the tree's own.
  void Suspend();
  void Resume();

  /// Did its thread get round to its work since the last call? For a heartbeat, to be called every
  /// second or so. A tree that rests, because it has ended, is suspended or stands at a breakpoint,
  /// counts as alive. One thread.
  bool IsAlive();

  /// Why the tree cannot be recorded now, or empty. Any thread.
  std::string RecordTrouble() const;
  /// Why it has no live socket, though it is to have one, or empty. Any thread.
  const std::string& LiveTrouble() const { return no_live_; }

  /// Puts a line into the record, for example an injected fault. Any thread.
  void Note(const std::string& kind, const std::string& text);

 private:
  void OpenRecord();
  void OpenSocket();
  bool BeginRun();
  bool IsResting();
  void RunTree(const std::function<void(Status)>& on_end);

  TreeRunnerOptions options_;
  Executor executor_;
  EventStream stream_;
  std::unique_ptr<Recorder> recorder_;
  std::string no_record_;  // why
  std::unique_ptr<LivePublisher> live_;
  std::string no_live_;  // why
  std::mutex mutex_;     // of what is below
  std::condition_variable changed_;
  bool is_stopping_ = false;
  bool is_suspended_ = false;
  bool is_resting_ = true;
  std::unique_ptr<Runner> runner_;  // one for each run
  std::thread thread_;
  // Set by the thread of the tree; it may outlive this in the inbox.
  const std::shared_ptr<std::atomic<bool>> answered_ = std::make_shared<std::atomic<bool>>(true);
};

/// Gives a key of the main tree a value from its text form, as if another node had written it.
Outcome SetKey(Executor& executor, const std::string& key, const std::string& text);

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_TREE_RUNNER_H_
