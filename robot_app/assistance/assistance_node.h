// The node /assistance: requests for help as ROS services, and /assistance/requests, latched. Thin:
// what is asked is decided by HelpDesk. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_NODE_H_
#define COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_NODE_H_

#include <ros/node_handle.h>

#include <vector>

#include "bt_core/base/clock.h"
#include "robot_app/assistance/help_desk.h"

namespace coppice::robot::assistance {

class AssistanceNode {
 public:
  AssistanceNode(ros::NodeHandle& node, HelpDesk& desk, const Clock& clock);

  /// Publishes the requests if they have changed, and now and then while one is open. An answer is
  /// also published on /assistance/answers.
  void Publish();

 private:
  template <class Service, class Handler>
  void Advertise(ros::NodeHandle& node, const char* name, Handler handler);
  void PublishAnswers();

  HelpDesk& desk_;
  const Clock& clock_;
  std::vector<ros::ServiceServer> services_;
  ros::Publisher requests_;
  ros::Publisher answers_;
  std::vector<std::uint32_t> open_;  // when last published
  std::uint64_t published_version_ = ~std::uint64_t{0};
  Time published_at_{};
};

}  // namespace coppice::robot::assistance

#endif  // COPPICE_ROBOT_APP_ASSISTANCE_ASSISTANCE_NODE_H_
