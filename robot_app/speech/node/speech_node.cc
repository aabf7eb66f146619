#include "robot_app/speech/node/speech_node.h"

#include <coppice_msgs/SpeechState.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <algorithm>

#include "robot_app/common/shipped.h"
#include "robot_app/knowledge/answers/real_way.h"
#include "robot_app/speech/node/spinner_task.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::robot::speech {
namespace {

constexpr double kWatchPeriod = 0.05;  // wall time [s]
constexpr double kStatePeriod = 1.0;   // wall time [s]
constexpr double kPosePatience = 0.5;  // wall time [s]
constexpr int kAnswerPriority = coppice_msgs::SpeakGoal::NORMAL;
constexpr std::size_t kLongestQuestion = 1000;  // bytes; no person asks more at once

void Warn(const std::string& problem) {
  if (!problem.empty()) ROS_WARN_STREAM(problem);
}

WallTime WallNow() { return std::chrono::system_clock::now(); }

}  // namespace

Expected<std::unique_ptr<SpeechNode>> SpeechNode::Make(SpeechSettings settings) {
  Complete(settings);
  Parts parts;
  auto clock = std::make_unique<RosClock>();
  auto output = MakeOutput(settings.output, *clock);
  if (!output) return Problem{output.problem()};
  parts.output = *std::move(output);
  auto device = DeviceOf(settings.microphone);
  if (!device) return Problem{device.problem()};
  parts.device = *std::move(device);
  if (!settings.knowledge.empty()) {
    auto opened =
        Conversation::Open(settings.knowledge, settings.site, Shipped(COPPICE_LANGUAGE_FOLDER));
    if (!opened) return Problem{opened.problem()};
    parts.conversation = *std::move(opened);
  }
  if (!knowledge::LanguageOf(settings.language)) {
    return Problem{"~language must be en or de, not \"" + settings.language + "\""};
  }
  if (settings.interface != "openai" && settings.interface != "google") {
    return Problem{"~transcription_interface must be openai or google, not \"" +
                   settings.interface + "\""};
  }
  if (!settings.places.empty()) {
    Diagnostics diagnostics;
    auto map = TopologicalMap::Load(settings.places, diagnostics);
    if (!map) return Problem{diagnostics.ToString()};
    parts.guide = std::make_unique<RouteGuide>(*std::move(map));
  }
  std::unique_ptr<SpeechNode> node(
      new SpeechNode(std::move(settings), std::move(clock), std::move(parts)));
  node->Serve();
  return node;
}

SpeechNode::SpeechNode(SpeechSettings settings, std::unique_ptr<RosClock> clock, Parts parts)
    : settings_(std::move(settings)),
      clock_(std::move(clock)),
      parts_(std::move(parts)),
      voices_(settings_.voices, Warn),
      mouth_(
          node_,
          [this](const std::string& text, const std::string& language) {
            return voices_.Speak(text, language);
          },
          *parts_.output, [this] { return SpokenNow(); }),
      ear_(settings_.ear, settings_.push_to_talk ? Listening::kPushToTalk : Listening::kAlways),
      saying_(node_.advertise<std_msgs::String>("/speech", 10)),
      heard_(node_.advertise<coppice_msgs::Heard>("/speech/heard", 10)),
      answer_(node_.advertise<coppice_msgs::Answer>("/speech/answer", 10)),
      state_(node_.advertise<coppice_msgs::SpeechState>("/speech/state", 10, true)) {
  watch_ = node_.createWallTimer(ros::WallDuration(kWatchPeriod),
                                 [this](const ros::WallTimerEvent&) { Watch(); });
  state_timer_ = node_.createWallTimer(ros::WallDuration(kStatePeriod),
                                       [this](const ros::WallTimerEvent&) { PublishState(); });
}

void SpeechNode::Serve() {
  if (!parts_.conversation) return;
  parts_.conversation->set_home_language(*knowledge::LanguageOf(settings_.language));
  if (parts_.guide) parts_.conversation->set_way([this] { return WayFromHere(); });
  parts_.conversation->set_least_sure(settings_.least_confidence);
  others_ = node_.subscribe("/speech/answer", 10, &SpeechNode::OnAnswer, this);
  services_.push_back(node_.advertiseService("/speech/ask", &SpeechNode::OnAsk, this));
  services_.push_back(node_.advertiseService("/speech/listen", &SpeechNode::OnListen, this));
  services_.push_back(node_.advertiseService("/speech/hear_file", &SpeechNode::OnHearFile, this));
  listener_ = std::make_unique<Listener>(
      ListenerSettings{settings_.knowledge, Shipped(COPPICE_LANGUAGE_FOLDER), kEnglishModel,
                       settings_.transcription, settings_.understanding, settings_.ends_early,
                       settings_.least_confidence, !parts_.device.empty()},
      [this](const HeardUtterance& heard) { SpinnerTask::Post([this, heard] { OnHeard(heard); }); },
      Warn);
  if (parts_.device.empty()) return;
  microphone_ = std::make_unique<Microphone>(
      parts_.device,
      [this](const std::vector<std::int16_t>& samples) {
        SpinnerTask::Post([this, samples] { OnSamples(samples); });
      },
      Warn);
}

std::string SpeechNode::SpokenNow() const {
  return parts_.conversation ? Code(parts_.conversation->language(WallNow())) : settings_.language;
}

// Few ask for what is near, and transforms come often: it listens to them only then.
knowledge::WayTo SpeechNode::WayFromHere() const {
  const RobotPose robot{Frames()};
  const ros::WallTime deadline = ros::WallTime::now() + ros::WallDuration(kPosePatience);
  while (ros::ok() && ros::WallTime::now() < deadline) {
    const auto newest = robot.Newest();
    if (newest) return knowledge::RealWay(*parts_.guide, newest->pose);
    ros::WallDuration(kWatchPeriod / 5).sleep();
  }
  return {};
}

void SpeechNode::OnSamples(const std::vector<std::int16_t>& samples) {
  ear_.set_speaks(mouth_.speaks(), clock_->Now());
  if (auto utterance = ear_.Hear(samples, clock_->Now())) Listen(*std::move(utterance), "");
}

void SpeechNode::Listen(Utterance utterance, const std::string& who) {
  listener_->Listen(std::move(utterance), parts_.conversation->language(WallNow()), who,
                    parts_.conversation->ExpectedNames(WallNow()));
}

void SpeechNode::OnHeard(const HeardUtterance& utterance) {
  if (utterance.pause && !ear_.End(*utterance.pause)) return;  // he goes on
  coppice_msgs::Heard heard;
  heard.header.stamp = ros::Time::now();
  heard.language = Code(utterance.language);
  heard.source = coppice_msgs::Heard::MICROPHONE;
  heard.who = utterance.who;
  Answer(heard, utterance.alternatives, settings_.answers_aloud, utterance.told, utterance.took);
}

coppice_msgs::Answer SpeechNode::Answer(const coppice_msgs::Heard& heard,
                                        const std::vector<knowledge::Alternative>& alternatives,
                                        bool aloud,
                                        const std::optional<knowledge::ToldMeaning>& told,
                                        std::chrono::nanoseconds took) {
  coppice_msgs::Answer answer =
      parts_.conversation->Answer(heard, alternatives, WallNow(), told, took);
  heard_.publish(answer.heard);
  answer.header.stamp = ros::Time::now();
  answer_.publish(answer);
  if (aloud) mouth_.Say(answer.text, answer.language, kAnswerPriority);
  return answer;
}

// What the tablet answers ends what was asked aloud, and tells which language its visitor speaks.
void SpeechNode::OnAnswer(const ros::MessageEvent<coppice_msgs::Answer const>& event) {
  if (event.getPublisherName() == ros::this_node::getName()) return;
  parts_.conversation->CloseQuestion();
  const auto language = knowledge::LanguageOf(event.getMessage()->language);
  if (!language) return;
  parts_.conversation->set_language(*language, WallNow());
  PublishState();
}

bool SpeechNode::OnAsk(coppice_msgs::Ask::Request& request, coppice_msgs::Ask::Response& response) {
  const auto longest = std::max({request.text.size(), request.language.size(), request.who.size()});
  if (longest > kLongestQuestion) {
    ROS_WARN("a question of %zu bytes is not answered", longest);
    return false;
  }
  coppice_msgs::Heard heard;
  heard.header.stamp = ros::Time::now();
  heard.language = request.language.empty() ? SpokenNow() : request.language;
  heard.source = request.source;
  heard.who = request.who;
  response.answer = Answer(heard, {{request.text, 1}}, request.aloud != 0);
  return true;
}

bool SpeechNode::OnListen(std_srvs::SetBool::Request& request,
                          std_srvs::SetBool::Response& response) {
  if (auto utterance = ear_.set_pressed(request.data != 0, clock_->Now())) {
    Listen(*std::move(utterance), "");
  }
  response.success = 1;
  PublishState();
  return true;
}

bool SpeechNode::OnHearFile(coppice_msgs::HearFile::Request& request,
                            coppice_msgs::HearFile::Response& response) {
  const Expected<Sound> sound = ReadWav(request.path);
  response.ok = 0;
  if (!sound) {
    response.message = sound.problem();
    return true;
  }
  ear_.set_speaks(mouth_.speaks(), clock_->Now());
  if (!ear_.is_open(clock_->Now())) {
    response.message = "the ear is shut";
    return true;
  }
  auto utterance = ear_.HearWhole(*sound);
  if (!utterance) {
    response.message = "nobody speaks in it";
    return true;
  }
  Listen(*std::move(utterance), request.who);
  response.ok = 1;
  return true;
}

// Tells what has changed, and keeps the ear shut.
void SpeechNode::Watch() {
  ear_.set_speaks(mouth_.speaks(), clock_->Now());
  if (mouth_.text() != was_saying_) {
    was_saying_ = mouth_.text();
    std_msgs::String message;
    message.data = was_saying_;
    saying_.publish(message);
  }
  const bool is_open = parts_.conversation && ear_.is_open(clock_->Now());
  if (mouth_.speaks() == was_speaking_ && is_open == was_open_ && ear_.hears() == was_hearing_) {
    return;
  }
  PublishState();
}

void SpeechNode::PublishState() {
  coppice_msgs::SpeechState state;
  state.header.stamp = ros::Time::now();
  was_speaking_ = mouth_.speaks();
  was_open_ = parts_.conversation && ear_.is_open(clock_->Now());
  was_hearing_ = ear_.hears();
  state.speaking = was_speaking_ ? 1 : 0;
  state.listening = was_open_ ? 1 : 0;
  state.hearing = was_hearing_ ? 1 : 0;
  state.language = SpokenNow();
  state.level = static_cast<float>(ear_.level());
  state_.publish(state);
}

}  // namespace coppice::robot::speech
