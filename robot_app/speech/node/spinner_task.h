// Hands work of another thread to the one that spins.
#ifndef COPPICE_ROBOT_APP_SPEECH_NODE_SPINNER_TASK_H_
#define COPPICE_ROBOT_APP_SPEECH_NODE_SPINNER_TASK_H_

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <utility>

namespace coppice::robot::speech {

class SpinnerTask : public ros::CallbackInterface {
 public:
  /// `run` is called by ros::spin soon. Any thread.
  static void Post(std::function<void()> run) {
    ros::getGlobalCallbackQueue()->addCallback(boost::make_shared<SpinnerTask>(std::move(run)));
  }

  explicit SpinnerTask(std::function<void()> run) : run_(std::move(run)) {}
  CallResult call() override {
    run_();
    return Success;
  }

 private:
  const std::function<void()> run_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_NODE_SPINNER_TASK_H_
