// The newest message of a topic, kept for a test that looks at it from its own thread.
//
//   Latest<sensor_msgs::LaserScan> scan(node, "/scan");
//   ASSERT_TRUE(Eventually([&] { return scan.get() != nullptr; }));
#ifndef COPPICE_TESTS_ROBOT_APP_LATEST_H_
#define COPPICE_TESTS_ROBOT_APP_LATEST_H_

#include <ros/node_handle.h>

#include <mutex>
#include <string>

namespace coppice::robot {

template <typename Message>
class Latest {
 public:
  Latest(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe<Message>(
            topic, 5, [this](const boost::shared_ptr<const Message>& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              message_ = message;
            })) {}
  ~Latest() { subscriber_.shutdown(); }

  /// Empty as long as none has come. Who goes through what is in it keeps it: the next message ends
  /// what nobody holds.
  boost::shared_ptr<const Message> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return message_;
  }
  /// Whether somebody publishes it: what is published before is lost.
  bool is_connected() const { return subscriber_.getNumPublishers() > 0; }
  void Forget() {
    const std::lock_guard<std::mutex> lock(mutex_);
    message_.reset();
  }

 private:
  mutable std::mutex mutex_;
  boost::shared_ptr<const Message> message_;
  ros::Subscriber subscriber_;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_ROBOT_APP_LATEST_H_
