// Asks other computers for their time and whether they are there, again and again, on a thread of
// its own, so that a network that hangs delays nothing but its own judgement.
#ifndef COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_WATCH_H_
#define COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_WATCH_H_

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "robot_app/monitoring/system/reach.h"
#include "robot_app/monitoring/system/sntp.h"

namespace coppice::robot::monitoring {

/// What is asked, and how often.
struct RemoteQuestions {
  std::vector<ClockServer> clocks;
  std::vector<ReachTarget> hosts;
  Duration period{0};
  Duration deadline{0};
};

struct RemoteAnswers {
  std::vector<Expected<ClockReading>> clocks;  ///< in the order of the questions
  std::vector<ReachDelay> hosts;
};

class RemoteWatch {
 public:
  RemoteWatch() = default;
  ~RemoteWatch();
  RemoteWatch(const RemoteWatch&) = delete;
  RemoteWatch& operator=(const RemoteWatch&) = delete;

  /// From now on, beginning at once; no questions, no thread. Answers to older questions are
  /// dropped.
  void Ask(RemoteQuestions questions);

  /// The answers of a round that is complete; each is given once. For any thread.
  std::optional<RemoteAnswers> Take();

 private:
  void Run(const RemoteQuestions& questions);
  void Stop();

  std::mutex mutex_;
  std::condition_variable stop_;
  bool stop_requested_ = false;
  std::optional<RemoteAnswers> answers_;
  std::thread thread_;
};

}  // namespace coppice::robot::monitoring

#endif  // COPPICE_ROBOT_APP_MONITORING_SYSTEM_REMOTE_WATCH_H_
