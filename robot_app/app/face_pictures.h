// What the robot's face, ears and arms show, from their topics, for those who watch its trees: the
// pictures "face" (the LED matrix, with the name of the expression), "ears" and "arms" (the colour
// of the strips, with the angles of the joints).
#ifndef COPPICE_ROBOT_APP_APP_FACE_PICTURES_H_
#define COPPICE_ROBOT_APP_APP_FACE_PICTURES_H_

#include <coppice_msgs/Lights.h>
#include <ros/node_handle.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/String.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "bt_core/live/pictures/live_pictures.h"

namespace coppice::robot {

/// As long as it lives. Where a topic is silent, its picture is missing, or as it was.
class FacePictures {
 public:
  explicit FacePictures(ros::NodeHandle& node);

  const std::shared_ptr<LivePictures>& pictures() const { return pictures_; }

 private:
  void OnImage(const sensor_msgs::Image& image);
  void OnExpression(const std_msgs::String& expression);
  void OnLights(const coppice_msgs::Lights& lights);
  void OnJoints(const sensor_msgs::JointState& joints);
  void Show(const LivePicture& picture) const;

  const std::shared_ptr<LivePictures> pictures_ = std::make_shared<LivePictures>();
  std::mutex mutex_;  // for the next three: of what is shown
  LivePicture face_{"face", "", 0, 0, {}};
  LivePicture ears_{"ears", "", 0, 0, {}};
  LivePicture arms_{"arms", "", 0, 0, {}};
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace coppice::robot

#endif  // COPPICE_ROBOT_APP_APP_FACE_PICTURES_H_
