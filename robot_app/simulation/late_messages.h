// Messages that are sent later than they were made, in the order of their times.
#ifndef COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_
#define COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_

#include <ros/publisher.h>

#include <functional>
#include <map>

namespace coppice::robot::simulation {

/// For one thread.
class LateMessages {
 public:
  /// `message` goes out with the first Send() at `time` or later.
  template <typename Message>
  void Add(double time, const ros::Publisher& publisher, const Message& message) {
    waiting_.emplace(time, [publisher, message] { publisher.publish(message); });
  }

  /// Sends what is due. If time has gone back, what waits is of another time and is forgotten.
  void Send(double time) {
    if (time < sent_until_) waiting_.clear();
    sent_until_ = time;
    while (!waiting_.empty() && waiting_.begin()->first <= time) {
      waiting_.begin()->second();
      waiting_.erase(waiting_.begin());
    }
  }

 private:
  std::multimap<double, std::function<void()>> waiting_;
  double sent_until_ = 0;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_
