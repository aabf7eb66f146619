// What an RGB-D camera sends: a picture in colour, the depth of its pixels, its lens; and which of
// them belong together. Subscribed to only while somebody wants to look.
#ifndef COPPICE_ROBOT_APP_PERCEPTION_CAMERA_RGBD_TOPICS_H_
#define COPPICE_ROBOT_APP_PERCEPTION_CAMERA_RGBD_TOPICS_H_

#include <ros/node_handle.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>

#include <functional>
#include <string>

#include "bt_core/base/outcome.h"
#include "robot_app/common/picture.h"

namespace coppice::robot::perception {

/// Of one moment, decoded.
struct RgbdMoment {
  std_msgs::Header header;  ///< of the picture: its time and optical frame
  Picture colour;           ///< without pixels: only the depth was asked for
  DepthPicture depth;       ///< without pixels: none came
  Lens lens;
};

/// The callback queue's thread.
class RgbdTopics {
 public:
  /// `changed` is called for every message that has come.
  RgbdTopics(ros::NodeHandle node, std::string name, std::function<void()> changed)
      : node_(std::move(node)), name_(std::move(name)), changed_(std::move(changed)) {}

  const std::string& name() const { return name_; }

  /// On: subscribes. Off: forgets what has come.
  void SetOn(bool is_on);
  bool is_on() const { return is_on_; }

  /// A new picture with its depth is there; with `without_depth` a picture alone is enough.
  bool HasMoment(bool without_depth) const;

  /// Decodes the newest picture and what belongs to it, which is taken only once. A problem says
  /// what is broken, or does not fit together.
  Expected<RgbdMoment> Take();

  /// A depth picture is there that neither Take nor TakeDepth has decoded.
  bool HasDepth() const { return is_depth_new_ && depth_ && info_; }

  /// The newest depth picture alone.
  Expected<RgbdMoment> TakeDepth();

  /// When a picture came last, or the topics were subscribed to; wall time.
  ros::WallTime last_picture() const { return last_picture_; }

 private:
  bool IsSameMoment() const;

  ros::NodeHandle node_;
  std::string name_;
  std::function<void()> changed_;
  bool is_on_ = false;
  ros::Subscriber colour_subscriber_, depth_subscriber_, info_subscriber_;
  sensor_msgs::CompressedImage::ConstPtr colour_;  // newest, not yet taken
  sensor_msgs::CompressedImage::ConstPtr depth_;   // newest
  bool is_depth_new_ = false;
  sensor_msgs::CameraInfo::ConstPtr info_;
  ros::WallTime last_picture_;
};

}  // namespace coppice::robot::perception

#endif  // COPPICE_ROBOT_APP_PERCEPTION_CAMERA_RGBD_TOPICS_H_
