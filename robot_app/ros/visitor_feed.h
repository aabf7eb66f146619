// Brings what visitors want to the trees: what was heard and answered (/speech/heard,
// /speech/answer), in which language is spoken with them (/speech/state) and that somebody uses
// the tablet (/tablet/touched). A wish to be guided lasts until a tree has settled it, the visitor
// takes it back, or wants something else; how it ended is told on /visitors/outcome.
#ifndef COPPICE_ROBOT_APP_ROS_VISITOR_FEED_H_
#define COPPICE_ROBOT_APP_ROS_VISITOR_FEED_H_

#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Heard.h>
#include <coppice_msgs/SpeechState.h>
#include <ros/node_handle.h>
#include <std_msgs/Empty.h>

#include <mutex>
#include <string>
#include <vector>

#include "bt_core/base/clock.h"
#include "bt_core/data/inbox.h"
#include "bt_nodes/visitors/visitor.h"

namespace coppice::robot::adapters {

class VisitorFeed : public leaves::Visitors {
 public:
  /// The clock stamps what arrives; it is that of the trees.
  VisitorFeed(ros::NodeHandle& node, const Clock& clock);

  /// The keys of the trees that use them; to be called once, before they run.
  void Connect(std::vector<Sender<leaves::Visitor>> trees);

  void Settle(int request, const std::string& outcome) override;

 private:
  void OnHeard(const coppice_msgs::Heard& heard);
  void OnAnswer(const coppice_msgs::Answer& answer);
  void OnState(const coppice_msgs::SpeechState& state);
  void OnTouched(const std_msgs::Empty&);
  void Send() const;
  void PublishOutcome(const std::string& outcome) const;

  const Clock& clock_;
  std::mutex mutex_;
  leaves::Visitor visitor_;
  int requests_ = 0;  // so far
  std::vector<Sender<leaves::Visitor>> trees_;
  ros::Publisher outcome_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_VISITOR_FEED_H_
