#include "robot_app/ros/visitor_feed.h"

#include <std_msgs/String.h>

#include <utility>

namespace coppice::robot::adapters {
namespace {

constexpr char kCancel[] = "cancel";  // the intent

}  // namespace

VisitorFeed::VisitorFeed(ros::NodeHandle& node, const Clock& clock)
    : clock_(clock),
      outcome_(node.advertise<std_msgs::String>("/visitors/outcome", 10)),
      subscribers_{node.subscribe("/speech/heard", 10, &VisitorFeed::OnHeard, this),
                   node.subscribe("/speech/answer", 10, &VisitorFeed::OnAnswer, this),
                   node.subscribe("/speech/state", 10, &VisitorFeed::OnState, this),
                   node.subscribe("/tablet/touched", 10, &VisitorFeed::OnTouched, this)} {}

void VisitorFeed::Connect(std::vector<Sender<leaves::Visitor>> trees) {
  const std::lock_guard lock(mutex_);
  for (Sender<leaves::Visitor>& tree : trees) {
    if (tree) trees_.push_back(std::move(tree));
  }
  Send();
}

void VisitorFeed::Settle(int request, const std::string& outcome) {
  const std::lock_guard lock(mutex_);
  if (visitor_.request != request) return;
  visitor_.request = 0;
  PublishOutcome(outcome);
  Send();
}

void VisitorFeed::OnHeard(const coppice_msgs::Heard& heard) {
  if (heard.text.empty()) return;  // noise
  const std::lock_guard lock(mutex_);
  visitor_.heard = clock_.Now();
  Send();
}

// Who wants to be led has nothing more to say: the talk is over.
void VisitorFeed::OnAnswer(const coppice_msgs::Answer& answer) {
  const std::lock_guard lock(mutex_);
  if (!answer.language.empty()) visitor_.language = answer.language;
  if (answer.intent == kCancel && visitor_.request != 0) {
    visitor_.request = 0;
    PublishOutcome("taken back");
  }
  const bool wants_to_be_led = answer.guides && !answer.place.empty();
  visitor_.heard = wants_to_be_led ? Time{} : clock_.Now();
  if (wants_to_be_led) {
    visitor_.request = ++requests_;
    visitor_.asked = clock_.Now();
    visitor_.place = answer.place;
  }
  Send();
}

void VisitorFeed::OnState(const coppice_msgs::SpeechState& state) {
  const std::lock_guard lock(mutex_);
  if (state.language.empty() || state.language == visitor_.language) return;
  visitor_.language = state.language;
  Send();
}

void VisitorFeed::OnTouched(const std_msgs::Empty&) {
  const std::lock_guard lock(mutex_);
  ++visitor_.touches;
  visitor_.heard = clock_.Now();
  Send();
}

void VisitorFeed::Send() const {
  for (const Sender<leaves::Visitor>& tree : trees_) tree.Send(visitor_);
}

void VisitorFeed::PublishOutcome(const std::string& outcome) const {
  std_msgs::String message;
  message.data = outcome;
  outcome_.publish(message);
}

}  // namespace coppice::robot::adapters
