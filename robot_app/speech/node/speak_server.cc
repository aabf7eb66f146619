#include "robot_app/speech/node/speak_server.h"

#include <algorithm>

namespace coppice::robot::speech {
namespace {

constexpr double kPeriod = 0.02;  // wall time; only while there is something to say [s]
constexpr std::size_t kMostText = 2000;

using Result = coppice_msgs::SpeakResult;

Result ResultOf(const MouthEvent& event) {
  Result result;
  result.message = event.message;
  switch (event.kind) {
    case MouthEvent::Kind::kWord:
    case MouthEvent::Kind::kPlayed:
      result.outcome = Result::PLAYED;
      break;
    case MouthEvent::Kind::kCancelled:
      result.outcome = Result::CANCELLED;
      break;
    case MouthEvent::Kind::kCut:
      result.outcome = Result::CUT;
      result.message = "something more urgent had to be said";
      break;
    case MouthEvent::Kind::kFailed:
      result.outcome = Result::FAILED;
      break;
  }
  return result;
}

}  // namespace

SpeakServer::SpeakServer(ros::NodeHandle& node, Synthesize synthesize, SoundOutput& output,
                         std::function<std::string()> spoken_now)
    : mouth_(std::move(synthesize), output),
      spoken_now_(std::move(spoken_now)),
      server_(
          node, "/speak", [this](Server::GoalHandle goal) { OnGoal(std::move(goal)); },
          [this](Server::GoalHandle goal) { OnCancel(std::move(goal)); }) {
  timer_ = node.createWallTimer(
      ros::WallDuration(kPeriod), [this](const ros::WallTimerEvent&) { Update(); }, false, false);
  server_.start();
}

void SpeakServer::Say(const std::string& text, const std::string& language, int priority) {
  mouth_.Add({next_id_++, text, language, priority});
  timer_.start();
}

void SpeakServer::OnGoal(Server::GoalHandle goal) {
  const auto wanted = goal.getGoal();
  if (wanted->text.size() > kMostText || wanted->language.size() > kMostText) {
    goal.setRejected({}, "the text is too long to be said");
    return;
  }
  goal.setAccepted();
  const std::string language = wanted->language.empty() ? spoken_now_() : wanted->language;
  goals_[next_id_] = goal;
  mouth_.Add({next_id_++, wanted->text, language, wanted->priority});
  timer_.start();
}

void SpeakServer::OnCancel(Server::GoalHandle goal) {
  const auto found = std::find_if(goals_.begin(), goals_.end(),
                                  [&](const auto& known) { return known.second == goal; });
  if (found == goals_.end()) return;
  mouth_.Cancel(found->first);
  Update();
}

void SpeakServer::Update() {
  for (const MouthEvent& event : mouth_.Update()) Tell(event);
  if (!mouth_.speaks()) timer_.stop();
}

void SpeakServer::Tell(const MouthEvent& event) {
  const auto found = goals_.find(event.id);
  if (found == goals_.end()) return;
  if (event.kind == MouthEvent::Kind::kWord) {
    coppice_msgs::SpeakFeedback feedback;
    feedback.begin = static_cast<std::uint32_t>(event.word.begin);
    feedback.length = static_cast<std::uint32_t>(event.word.length);
    found->second.publishFeedback(feedback);
    return;
  }
  End(found->second, event);
  goals_.erase(found);
}

void SpeakServer::End(Server::GoalHandle& goal, const MouthEvent& event) {
  const Result result = ResultOf(event);
  if (event.kind == MouthEvent::Kind::kPlayed) {
    goal.setSucceeded(result);
  } else if (event.kind == MouthEvent::Kind::kCancelled) {
    goal.setCanceled(result);
  } else {
    goal.setAborted(result, result.message);
  }
}

}  // namespace coppice::robot::speech
