// One action server as a capability: start a goal, hear how it ended, cancel it.
//
// It never leaves the caller without an answer: a server that is not there within kConnectTimeout,
// that does not take the goal, or that dies while it works, is reported as a failure that says so.
// Where that would be taken for a failure of the action itself, whoever is started in the place of
// a server that died gets the goal, too, once.
// Times are real time, because programs start and die in real time.
//
// It stands on actionlib's ActionClient: SimpleActionClient keeps the goal that it sends in a
// member that its callbacks read, so where several threads spin, a goal that ends before sendGoal()
// has returned is called lost, or its end is not told at all.
//
// A status that the server sent before it had the goal may arrive after it took it. actionlib then
// calls the goal lost, though the server works on it: such a goal is sent again, once. So is one
// that nobody has taken within kTakenTimeout: it went to a server that hung, and to whoever was
// started in its place nobody has told it. actionlib would wait for ever.
//
// What nobody wants any more must not be worked on: goals and cancellations go different ways, and
// a goal may be overtaken by its cancellation. So a server that takes one that was cancelled is
// told again, and one that does not take its goal is told that it is not to do so later.
#ifndef COPPICE_ROBOT_APP_ROS_ACTION_PORT_H_
#define COPPICE_ROBOT_APP_ROS_ACTION_PORT_H_

#include <actionlib/client/action_client.h>
#include <ros/node_handle.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "bt_core/data/inbox.h"
#include "bt_nodes/basics/action_result.h"

namespace coppice::robot::adapters {

/// What is to be done about a server that dies while it works.
enum class WhenGone { kFails, kAsksItsSuccessor };

template <class ActionSpec>
class ActionPort {
 public:
  // Not by ACTION_DEFINITION, whose ActionResult would hide ours.
  using Goal = typename ActionSpec::_action_goal_type::_goal_type;
  using Result = typename ActionSpec::_action_result_type::_result_type;
  using Client = actionlib::ActionClient<ActionSpec>;
  /// Turns the end of a goal into the answer; the state is ABORTED, SUCCEEDED, ...
  using Evaluate =
      std::function<leaves::ActionResult(const actionlib::TerminalState&, const Result*)>;

  ActionPort(ros::NodeHandle& node, const std::string& name, Evaluate evaluate,
             WhenGone when_gone = WhenGone::kFails)
      : name_(name), evaluate_(std::move(evaluate)), when_gone_(when_gone), client_(node, name) {
    timer_ = node.createWallTimer(ros::WallDuration(0.1), [this](const auto&) { Supervise(); });
  }

  /// Replaces a goal that is still active, whose sender is then not used any more.
  void Start(const Goal& goal, const Sender<leaves::ActionResult>& done) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++number_;
    goal_ = goal;
    done_ = done;
    was_sent_again_ = false;
    state_ = State::kConnecting;
    since_ = ros::WallTime::now();
  }

  /// Whether the server is there.
  bool is_connected() { return client_.isServerConnected(); }

  void Cancel() {
    bool was_sent = false;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      was_sent = state_ == State::kSent;
      state_ = State::kNone;
      ++number_;
    }
    if (was_sent) client_.cancelAllGoals();
  }

 private:
  enum class State { kNone, kConnecting, kSent };
  static constexpr double kConnectTimeout = 5.0;   // s
  static constexpr double kLostTimeout = 1.0;      // s
  static constexpr double kOvertakeTimeout = 1.0;  // s
  static constexpr double kTakenTimeout = 3.0;     // s

  // Runs on the spinner: sends a goal as soon as the server is there, and notices when it goes
  // away.
  void Supervise() {
    // Without our lock: actionlib holds its own when it calls us.
    const bool connected = client_.isServerConnected();
    const bool waits_to_be_taken = WaitsToBeTaken();
    const ros::WallTime now = ros::WallTime::now();
    std::unique_lock<std::mutex> lock(mutex_);
    if (state_ == State::kNone) return;
    if (state_ == State::kConnecting) {
      if (connected) {
        state_ = State::kSent;
        since_ = sent_ = now;
        const Goal goal = goal_;
        const int number = number_;
        lock.unlock();
        handle_ = client_.sendGoal(goal, [this, number, now](typename Client::GoalHandle sent) {
          if (sent.getCommState() == actionlib::CommState::DONE) {
            End(number, now, sent);
          } else if (sent.getCommState() == actionlib::CommState::ACTIVE && !IsWanted(number)) {
            sent.cancel();
          }
        });
      } else if ((now - since_).toSec() > kConnectTimeout) {
        lock.unlock();
        Finish(number_, {false, "no action server \"" + name_ + "\""});
      }
      return;
    }
    if (connected && waits_to_be_taken && (now - sent_).toSec() > kTakenTimeout) {
      const int number = number_;
      lock.unlock();
      if (SendAgain(number)) return;
      handle_.cancel();
      handle_.reset();
      Finish(number, {false, "action server \"" + name_ + "\" does not take the goal"});
    } else if (connected) {
      since_ = now;
    } else if ((now - since_).toSec() > kLostTimeout) {
      const int number = number_;
      lock.unlock();
      handle_.reset();
      if (when_gone_ == WhenGone::kAsksItsSuccessor && SendAgain(number)) return;
      Finish(number, {false, "action server \"" + name_ + "\" is gone"});
    }
  }

  bool WaitsToBeTaken() {
    return !handle_.isExpired() &&
           handle_.getCommState() == actionlib::CommState::WAITING_FOR_GOAL_ACK;
  }

  bool IsWanted(int number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return number == number_;
  }

  void End(int number, ros::WallTime sent, const typename Client::GoalHandle& goal) {
    const actionlib::TerminalState state = goal.getTerminalState();
    const bool is_lost = state == actionlib::TerminalState::LOST;
    // Not if it was sent too long ago for a status to have overtaken it.
    const bool was_overtaken = is_lost && (ros::WallTime::now() - sent).toSec() <= kOvertakeTimeout;
    // Who was started so soon that nobody missed the one before does not know the goal.
    const bool has_successor = is_lost && when_gone_ == WhenGone::kAsksItsSuccessor;
    if ((was_overtaken || has_successor) && SendAgain(number)) return;
    Finish(number, evaluate_(state, goal.getResult().get()));
  }

  // False if it was sent twice already.
  bool SendAgain(int number) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (number != number_ || state_ != State::kSent || was_sent_again_) return false;
    was_sent_again_ = true;
    state_ = State::kConnecting;
    since_ = ros::WallTime::now();
    return true;
  }

  void Finish(int number, const leaves::ActionResult& result) {
    Sender<leaves::ActionResult> done;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (number != number_ || state_ == State::kNone) return;
      state_ = State::kNone;
      done = done_;
    }
    done.Send(result);
  }

  const std::string name_;
  const Evaluate evaluate_;
  const WhenGone when_gone_;

  std::mutex mutex_;
  State state_ = State::kNone;
  int number_ = 0;  // of the goal; answers to earlier ones are dropped
  Goal goal_;
  Sender<leaves::ActionResult> done_;
  bool was_sent_again_ = false;
  ros::WallTime since_;  // of the state; in kSent the last time the server was seen
  ros::WallTime sent_;   // in kSent

  // Last: their callbacks use all of the above until they are gone.
  Client client_;
  typename Client::GoalHandle handle_;  // tracks the goal while it lives; used by the timer only
  ros::WallTimer timer_;
};

/// ok if the goal succeeded, else the server's text.
inline leaves::ActionResult FromGoalState(const actionlib::TerminalState& state) {
  if (state == actionlib::TerminalState::SUCCEEDED) return {true, ""};
  return {false, state.getText().empty() ? state.toString() : state.getText()};
}

}  // namespace coppice::robot::adapters

#endif  // COPPICE_ROBOT_APP_ROS_ACTION_PORT_H_
