// coppice-speech: the robot's mouth and ear as the ROS node /speech.
#include <ros/ros.h>

#include <cstdio>

#include "robot_app/common/ros_support.h"
#include "robot_app/speech/node/speech_node.h"

namespace coppice::robot::speech {
namespace {

constexpr char kHelp[] =
    "coppice-speech: speaks, hears and answers, as the ROS node /speech.\n"
    "  action      /speak (coppice_msgs/Speak)\n"
    "  services    /speech/ask (a question in writing), /speech/listen (push to talk),\n"
    "              /speech/hear_file (a WAV file instead of the microphone)\n"
    "  publishes   /speech (what is being said), /speech/heard, /speech/answer, /speech/state\n"
    "The keys of services are read from COPPICE_SPEECH_KEY, COPPICE_TRANSCRIPTION_KEY and\n"
    "COPPICE_UNDERSTANDING_KEY.\n"
    "Where there is no sound card, speech takes its time on the clock of ROS.\n";

}  // namespace
}  // namespace coppice::robot::speech

int main(int argc, char** argv) {
  namespace speech = coppice::robot::speech;
  return coppice::robot::RunNode<speech::SpeechSettings>(
      argc, argv, "speech", speech::kHelp, [](const speech::SpeechSettings& settings) {
        const auto node = speech::SpeechNode::Make(settings);
        if (!node) {
          std::fprintf(stderr, "coppice-speech: %s\n", node.problem().c_str());
          return 2;
        }
        ros::spin();
        return 0;
      });
}
