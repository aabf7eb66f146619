// Messages that are sent later than they were made, in the order of their times.
#ifndef COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_
#define COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_

#include <ros/publisher.h>
#include <ros/serialization.h>

#include <cstddef>
#include <functional>
#include <map>

namespace coppice::robot::simulation {

/// For one thread.
class LateMessages {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{64} << 20;

  /// `message` goes out with the first Send() at `time` or later. Beyond kMostBytes the earliest
  /// are lost, as in a network.
  template <typename Message>
  void Add(double time, const ros::Publisher& publisher, const Message& message) {
    const std::size_t bytes = ros::serialization::serializationLength(message);
    waiting_.emplace(time, Waiting{bytes, [publisher, message] { publisher.publish(message); }});
    bytes_ += bytes;
    while (bytes_ > kMostBytes) Forget();
  }

  /// Sends what is due. If time has gone back, what waits is of another time and is forgotten.
  void Send(double time) {
    while (time < sent_until_ && !waiting_.empty()) Forget();
    sent_until_ = time;
    while (!waiting_.empty() && waiting_.begin()->first <= time) {
      waiting_.begin()->second.send();
      Forget();
    }
  }

  std::size_t bytes() const { return bytes_; }  ///< of what waits

 private:
  struct Waiting {
    std::size_t bytes;
    std::function<void()> send;
  };

  // The earliest.
  void Forget() {
    bytes_ -= waiting_.begin()->second.bytes;
    waiting_.erase(waiting_.begin());
  }

  std::multimap<double, Waiting> waiting_;
  std::size_t bytes_ = 0;
  double sent_until_ = 0;
};

}  // namespace coppice::robot::simulation

#endif  // COPPICE_ROBOT_APP_SIMULATION_LATE_MESSAGES_H_
