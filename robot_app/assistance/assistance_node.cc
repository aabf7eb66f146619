#include "robot_app/assistance/assistance_node.h"

#include <coppice_msgs/AnswerHelp.h>
#include <coppice_msgs/AskForHelp.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/TellSupervisors.h>
#include <coppice_msgs/WithdrawHelp.h>

#include <cmath>

namespace coppice::robot::assistance {
namespace {

constexpr Duration kPublishPeriod = std::chrono::seconds(2);
constexpr double kMostDeadline = 7 * 86400.0;

ros::Time ToRosTime(Time time) {
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(ToNanoseconds(time)));
  return stamp;
}

coppice_msgs::HelpRequest ToMessage(const HelpRequest& request, Time now) {
  coppice_msgs::HelpRequest message;
  message.id = request.id;
  message.subject = request.subject;
  message.question = request.question;
  message.state = static_cast<std::uint8_t>(request.state);
  message.opened = ToRosTime(request.opened);
  if (request.state == HelpState::kOpen) {
    message.seconds_left = std::chrono::duration<double>(request.deadline - now).count();
  }
  for (const AskedSupervisor& asked : request.asked) message.asked.push_back(asked.name);
  message.taken_by = request.taken_by;
  message.answered_by = request.answered_by;
  message.ok = request.ok;
  message.message = request.message;
  return message;
}

// What is no sensible number of seconds counts as none.
Duration ToDeadline(double seconds) {
  if (!std::isfinite(seconds) || seconds <= 0 || seconds > kMostDeadline) return Duration::zero();
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

AssistanceNode::AssistanceNode(ros::NodeHandle& node, HelpDesk& desk, const Clock& clock)
    : desk_(desk), clock_(clock) {
  requests_ = node.advertise<coppice_msgs::HelpRequests>("/assistance/requests", 10, true);
  answers_ = node.advertise<coppice_msgs::HelpRequest>("/assistance/answers", 20);
  Advertise<coppice_msgs::AskForHelp>(node, "ask", [this](auto& request, auto& response) {
    const Expected<std::uint32_t> id =
        desk_.Ask(request.subject, request.question, clock_.Now(), ToDeadline(request.deadline));
    if (!id) {  // the service has no answer that could tell why
      ROS_ERROR_THROTTLE(10, "%s", id.problem().c_str());
      return false;
    }
    response.id = *id;
    return true;
  });
  Advertise<coppice_msgs::WithdrawHelp>(node, "withdraw", [this](auto& request, auto& response) {
    response.ok = desk_.Withdraw(request.subject, clock_.Now());
    return true;
  });
  Advertise<coppice_msgs::TellSupervisors>(node, "tell", [this](auto& request, auto&) {
    desk_.Tell(request.subject, request.message);
    return true;
  });
  Advertise<coppice_msgs::AnswerHelp>(node, "answer", [this](auto& request, auto& response) {
    const Expected<std::string> told =
        desk_.Answer(request.id, request.by, request.fixed, clock_.Now());
    response.ok = told.ok();
    response.message = told ? *told : told.problem();
    return true;
  });
}

template <class Service, class Handler>
void AssistanceNode::Advertise(ros::NodeHandle& node, const char* name, Handler handler) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  services_.push_back(node.advertiseService(
      std::string("/assistance/") + name,
      boost::function<bool(Request&, Response&)>(
          [handler](Request& request, Response& response) { return handler(request, response); })));
}

void AssistanceNode::Publish() {
  const Time now = clock_.Now();
  const bool is_old = !open_.empty() && now - published_at_ >= kPublishPeriod;
  if (desk_.version() == published_version_ && !is_old) return;
  published_version_ = desk_.version();
  published_at_ = now;
  PublishAnswers();
  coppice_msgs::HelpRequests list;
  list.header.stamp = ros::Time::now();
  for (const HelpRequest& request : desk_.requests()) {
    list.requests.push_back(ToMessage(request, now));
    if (request.state == HelpState::kOpen) open_.push_back(request.id);
  }
  requests_.publish(list);
}

// Of those that were open the last time.
void AssistanceNode::PublishAnswers() {
  for (const std::uint32_t id : open_) {
    const HelpRequest* const request = desk_.Find(id);
    if (request && request->state != HelpState::kOpen) {
      answers_.publish(ToMessage(*request, clock_.Now()));
    }
  }
  open_.clear();
}

}  // namespace coppice::robot::assistance
