#include "robot_app/perception/camera/rgbd_topics.h"

#include <cmath>

#include "robot_app/common/compressed_picture.h"

namespace coppice::robot::perception {
namespace {

constexpr double kSameMoment = 0.04;  // between the stamps of a picture and its depth [s]
constexpr double kWidestLens = 1e5;   // pixels

Expected<Lens> LensOf(const sensor_msgs::CameraInfo& info, int width, int height) {
  const Lens lens{info.K[0], info.K[4], info.K[2], info.K[5]};
  const bool is_lens = lens.fx > 1 && lens.fy > 1 && lens.fx < kWidestLens &&
                       lens.fy < kWidestLens && lens.cx > 0 && lens.cx < info.width &&
                       lens.cy > 0 && lens.cy < info.height;
  if (!is_lens) return Problem{"the camera_info says no lens: expected fx, fy, cx, cy in K"};
  if (static_cast<int>(info.width) != width || static_cast<int>(info.height) != height) {
    return Problem{"the camera_info is for " + std::to_string(info.width) + " x " +
                   std::to_string(info.height) + " pixels, the picture has " +
                   std::to_string(width) + " x " + std::to_string(height)};
  }
  return lens;
}

Expected<DepthPicture> DepthOf(const sensor_msgs::CompressedImage& message, const Picture& colour) {
  auto depth = DecodeDepth(message.data);
  if (!depth) return depth;
  if (depth->width != colour.width || depth->height != colour.height) {
    return Problem{"the depth has " + std::to_string(depth->width) + " x " +
                   std::to_string(depth->height) + " pixels, the picture " +
                   std::to_string(colour.width) + " x " + std::to_string(colour.height)};
  }
  return depth;
}

}  // namespace

void RgbdTopics::SetOn(bool is_on) {
  if (is_on == is_on_) return;
  is_on_ = is_on;
  last_picture_ = ros::WallTime::now();
  colour_.reset();
  depth_.reset();
  if (!is_on) {
    colour_subscriber_ = depth_subscriber_ = info_subscriber_ = ros::Subscriber();
    return;
  }
  using sensor_msgs::CameraInfo;
  using sensor_msgs::CompressedImage;
  const std::string camera = "/camera/" + name_;
  const auto keep = [this](CompressedImage::ConstPtr& newest) {
    return boost::function<void(const CompressedImage::ConstPtr&)>(
        [this, &newest](const CompressedImage::ConstPtr& message) {
          newest = message;
          if (&newest == &colour_) {
            last_picture_ = ros::WallTime::now();
          } else {
            is_depth_new_ = true;
          }
          changed_();
        });
  };
  colour_subscriber_ =
      node_.subscribe<CompressedImage>(camera + "/color/image_raw/compressed", 1, keep(colour_));
  depth_subscriber_ = node_.subscribe<CompressedImage>(
      camera + "/aligned_depth_to_color/image_raw/compressedDepth", 1, keep(depth_));
  info_subscriber_ = node_.subscribe<CameraInfo>(
      camera + "/color/camera_info", 1,
      boost::function<void(const CameraInfo::ConstPtr&)>(
          [this](const CameraInfo::ConstPtr& message) { info_ = message; }));
}

bool RgbdTopics::IsSameMoment() const {
  return std::abs(colour_->header.stamp.toSec() - depth_->header.stamp.toSec()) <= kSameMoment;
}

bool RgbdTopics::HasMoment(bool without_depth) const {
  if (!colour_ || !info_) return false;
  return without_depth || (depth_ && IsSameMoment());
}

Expected<RgbdMoment> RgbdTopics::Take() {
  const sensor_msgs::CompressedImage::ConstPtr colour = std::move(colour_);
  colour_.reset();
  auto picture = DecodeJpeg(colour->data);
  if (!picture) return Problem{picture.problem()};
  RgbdMoment moment;
  moment.header = colour->header;
  const Expected<Lens> lens = LensOf(*info_, picture->width, picture->height);
  if (!lens) return Problem{lens.problem()};
  moment.lens = *lens;
  moment.colour = *std::move(picture);
  // Not as a ros::Duration, which throws where it is longer than 68 years.
  const double later = depth_ ? depth_->header.stamp.toSec() - moment.header.stamp.toSec() : 0;
  const bool has_depth = depth_ && std::abs(later) <= kSameMoment;
  if (has_depth) {
    auto depth = DepthOf(*depth_, moment.colour);
    if (!depth) return Problem{depth.problem()};
    moment.depth = *std::move(depth);
    is_depth_new_ = false;
  }
  return moment;
}

Expected<RgbdMoment> RgbdTopics::TakeDepth() {
  is_depth_new_ = false;
  auto depth = DecodeDepth(depth_->data);
  if (!depth) return Problem{depth.problem()};
  const Expected<Lens> lens = LensOf(*info_, depth->width, depth->height);
  if (!lens) return Problem{lens.problem()};
  RgbdMoment moment;
  moment.header = depth_->header;
  moment.lens = *lens;
  moment.depth = *std::move(depth);
  return moment;
}

}  // namespace coppice::robot::perception
