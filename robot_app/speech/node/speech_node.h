// The node /speech: mouth, ear and conversation. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_NODE_H_
#define COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_NODE_H_

#include <coppice_msgs/Ask.h>
#include <coppice_msgs/HearFile.h>
#include <coppice_msgs/Heard.h>
#include <ros/node_handle.h>
#include <std_srvs/SetBool.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot_app/common/places/route_guide.h"
#include "robot_app/common/ros_clock.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/speech/ear/microphone.h"
#include "robot_app/speech/node/conversation.h"
#include "robot_app/speech/node/speak_server.h"
#include "robot_app/speech/node/speech_settings.h"

namespace coppice::robot::speech {

class SpeechNode {
 public:
  /// A problem if a parameter names nothing that is there.
  static Expected<std::unique_ptr<SpeechNode>> Make(SpeechSettings settings);

 private:
  struct Parts {
    std::unique_ptr<SoundOutput> output;
    std::unique_ptr<Conversation> conversation;  // null: it only speaks
    std::unique_ptr<RouteGuide> guide;           // null: nearest is as the crow flies
    std::string device;                          // of the microphone; empty: none
  };
  SpeechNode(SpeechSettings settings, std::unique_ptr<RosClock> clock, Parts parts);
  void Serve();

  void OnSamples(const std::vector<std::int16_t>& samples);
  void Listen(Utterance utterance, const std::string& who);
  void OnHeard(const HeardUtterance& utterance);
  coppice_msgs::Answer Answer(const coppice_msgs::Heard& heard,
                              const std::vector<knowledge::Alternative>& alternatives, bool aloud,
                              const std::optional<knowledge::ToldMeaning>& told = std::nullopt,
                              std::chrono::nanoseconds took = {});
  void OnAnswer(const ros::MessageEvent<coppice_msgs::Answer const>& event);

  bool OnAsk(coppice_msgs::Ask::Request& request, coppice_msgs::Ask::Response& response);
  bool OnListen(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool OnHearFile(coppice_msgs::HearFile::Request& request,
                  coppice_msgs::HearFile::Response& response);
  void Watch();
  void PublishState();
  std::string SpokenNow() const;
  knowledge::WayTo WayFromHere() const;

  const SpeechSettings settings_;
  ros::NodeHandle node_;
  const std::unique_ptr<RosClock> clock_;
  const Parts parts_;
  Voices voices_;
  SpeakServer mouth_;
  Ear ear_;
  bool was_speaking_ = false, was_hearing_ = false, was_open_ = false;
  std::string was_saying_;
  ros::Publisher saying_, heard_, answer_, state_;
  std::vector<ros::ServiceServer> services_;
  ros::Subscriber others_;
  ros::WallTimer watch_, state_timer_;
  // Last: their threads use all of the above until they are gone.
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<Microphone> microphone_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_NODE_SPEECH_NODE_H_
