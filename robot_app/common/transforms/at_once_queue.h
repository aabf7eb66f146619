// A callback queue that is none: what comes is handled at once, by the thread that brings it. For
// handlers that only count: to hand a message over to another thread costs more than to count it.
//
//   ros::SubscribeOptions options = ...;
//   options.callback_queue = &at_once_;
//
// A handler must not (un)subscribe, and who (un)subscribes must not hold what a handler waits for:
// roscpp keeps a lock of the subscription meanwhile. The queue lives longer than its subscribers.
#ifndef COPPICE_ROBOT_APP_COMMON_TRANSFORMS_AT_ONCE_QUEUE_H_
#define COPPICE_ROBOT_APP_COMMON_TRANSFORMS_AT_ONCE_QUEUE_H_

#include <ros/callback_queue_interface.h>

namespace coppice::robot {

class AtOnceQueue : public ros::CallbackQueueInterface {
 public:
  void addCallback(const ros::CallbackInterfacePtr& callback, std::uint64_t) override {
    callback->call();
  }
  void removeByID(std::uint64_t) override {}  // nothing waits here
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_COMMON_TRANSFORMS_AT_ONCE_QUEUE_H_
