#include "robot_app/app/face_pictures.h"

#include <algorithm>
#include <cmath>

namespace coppice::robot {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;
constexpr double kFullTurns = 100;  // a servo that says more is broken
constexpr int kStep = 5;            // what is told of angles [degrees]: they turn in every message

std::uint8_t ToByte(float part) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0F, 1.0F)));
}

void Paint(const std_msgs::ColorRGBA& colour, LivePicture& lamp) {
  lamp.width = lamp.height = 1;
  lamp.rgb = {ToByte(colour.r), ToByte(colour.g), ToByte(colour.b)};
}

// "20°"; empty if the message does not tell it.
std::string AngleOf(const sensor_msgs::JointState& joints, const std::string& name) {
  const auto at = std::find(joints.name.begin(), joints.name.end(), name);
  const auto index = static_cast<std::size_t>(at - joints.name.begin());
  if (index >= joints.position.size()) return "";
  const double degrees = joints.position[index] * kDegrees;
  if (!(std::abs(degrees) < kFullTurns * 360)) return "";
  return std::to_string(kStep * std::lround(degrees / kStep)) + "°";
}

// "20° -20°", left and right.
std::string AnglesOf(const sensor_msgs::JointState& joints, const std::string& limb) {
  const std::string left = AngleOf(joints, "left_" + limb + "_joint");
  const std::string right = AngleOf(joints, "right_" + limb + "_joint");
  return left.empty() || right.empty() ? "" : left + " " + right;
}

}  // namespace

FacePictures::FacePictures(ros::NodeHandle& node)
    : subscribers_{node.subscribe("/face/image", 2, &FacePictures::OnImage, this),
                   node.subscribe("/face/expression", 2, &FacePictures::OnExpression, this),
                   node.subscribe("/face/lights", 2, &FacePictures::OnLights, this),
                   node.subscribe("/joint_states", 2, &FacePictures::OnJoints, this)} {}

void FacePictures::OnImage(const sensor_msgs::Image& image) {
  const std::size_t row = std::size_t{3} * image.width;
  if (image.encoding != "rgb8" || image.step < row) return;
  const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
  if (pixels == 0 || pixels > PictureSet::kMostPixels) return;  // none that anybody could be shown
  if (image.data.size() < std::size_t{image.step} * image.height) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  face_.width = image.width;
  face_.height = image.height;
  face_.rgb.clear();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const auto begin = image.data.begin() + static_cast<std::ptrdiff_t>(y) * image.step;
    face_.rgb.insert(face_.rgb.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
  }
  Show(face_);
}

void FacePictures::OnExpression(const std_msgs::String& expression) {
  const std::lock_guard<std::mutex> lock(mutex_);
  face_.text = expression.data.substr(0, PictureSet::kLongestText);
  Show(face_);
}

void FacePictures::OnLights(const coppice_msgs::Lights& lights) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Paint(lights.ears, ears_);
  Paint(lights.arms, arms_);
  Show(ears_);
  Show(arms_);
}

void FacePictures::OnJoints(const sensor_msgs::JointState& joints) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (LivePicture* limb : {&ears_, &arms_}) {
    const std::string angles = AnglesOf(joints, limb == &ears_ ? "ear" : "arm");
    if (angles.empty() || angles == limb->text) continue;
    limb->text = angles;
    Show(*limb);
  }
}

// Words may come before the picture.
void FacePictures::Show(const LivePicture& picture) const {
  if (picture.rgb.empty()) return;
  if (const Outcome shown = pictures_->Show(picture); !shown) {
    ROS_WARN_THROTTLE(10, "watchers do not see it: %s", shown.problem().c_str());
  }
}

}  // namespace coppice::robot
