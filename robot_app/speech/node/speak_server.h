// The action /speak on the mouth. For the thread that spins.
#ifndef COPPICE_ROBOT_APP_SPEECH_NODE_SPEAK_SERVER_H_
#define COPPICE_ROBOT_APP_SPEECH_NODE_SPEAK_SERVER_H_

#include <coppice_msgs/SpeakAction.h>
#include <ros/node_handle.h>

#include <functional>
#include <map>
#include <string>

#include "robot_app/common/actions/patient_server.h"
#include "robot_app/speech/mouth/mouth.h"

namespace coppice::robot::speech {

class SpeakServer {
 public:
  /// `spoken_now`: the language of goals that name none.
  SpeakServer(ros::NodeHandle& node, Synthesize synthesize, SoundOutput& output,
              std::function<std::string()> spoken_now);

  /// Says something that is nobody's goal.
  void Say(const std::string& text, const std::string& language, int priority);
  bool speaks() const { return mouth_.speaks(); }
  /// What is being said; empty: nothing.
  std::string text() const { return mouth_.text(); }

 private:
  using Server = PatientServer<coppice_msgs::SpeakAction>;

  void OnGoal(Server::GoalHandle goal);
  void OnCancel(Server::GoalHandle goal);
  void Update();
  void Tell(const MouthEvent& event);
  void End(Server::GoalHandle& goal, const MouthEvent& event);

  Mouth mouth_;
  const std::function<std::string()> spoken_now_;
  std::map<std::int64_t, Server::GoalHandle> goals_;
  std::int64_t next_id_ = 1;
  ros::WallTimer timer_;
  Server server_;
};

}  // namespace coppice::robot::speech

#endif  // COPPICE_ROBOT_APP_SPEECH_NODE_SPEAK_SERVER_H_
