// Calls of ROS services, and whatever else waits (for a disk), that must not hold up the thread
// that spins: one after the other on a thread of their own; what came of them is handed back.
#ifndef COPPICE_ROBOT_APP_COMMON_SERVICE_CALLER_H_
#define COPPICE_ROBOT_APP_COMMON_SERVICE_CALLER_H_

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace coppice::robot {

class ServiceCaller {
 public:
  static constexpr std::size_t kMostWaiting = 16;

  ServiceCaller();
  ~ServiceCaller();  // drops what was not begun, waits for the call in progress

  using Finish = std::function<void()>;
  using Call = std::function<Finish()>;
  /// `call` runs on the thread of the calls; what it returns is run by RunFinished. False: too many
  /// wait already.
  bool Add(Call call);
  void RunFinished();

 private:
  void Work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Call> calls_;
  std::deque<Finish> finished_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_SERVICE_CALLER_H_
