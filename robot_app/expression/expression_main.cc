// coppice-expression: the node /expression, which shows how the robot feels. Face, lights, ears and
// arms are simulated, with the topics that the drivers of real ones subscribe to.
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Expression.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/Lights.h>
#include <coppice_msgs/SpeechState.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/String.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "robot_app/common/ros_support.h"
#include "robot_app/common/shipped.h"
#include "robot_app/expression/expression_table.h"
#include "robot_app/expression/face_painter.h"
#include "robot_app/expression/light_markers.h"
#include "robot_app/expression/limbs.h"
#include "robot_app/expression/wishes.h"

namespace coppice::robot::expression {
namespace {

constexpr char kHelp[] =
    "coppice-expression: shows how the robot feels, as the ROS node /expression.\n"
    "  subscribes  /expression (what trees and tablet want), /speech/state (listening),\n"
    "              /speech/answer (sad if there is none), /assistance/requests (asking for help)\n"
    "  publishes   /face/image (64 x 32 pixels), /face/lights, /joint_states and /tf (ears, arms),\n"
    "              /face/expression (the one that is shown), /face/light_markers (for RViz)\n"
    "Animations run in wall time.\n";

constexpr double kPeriod = 0.05;      // s
constexpr double kHeard = 3;          // a wish that is said again every second holds so long [s]
constexpr double kForEver = 1e9;      // until it is withdrawn [s]
constexpr double kLeastSad = 2.5;     // s
constexpr double kSadPerByte = 0.06;  // of the answer [s]

struct Settings {
  std::string expressions = "shipped";
  std::string robot = "sobi";
};

Parameters ParametersOf(Settings& settings) {
  return {{"expressions", &settings.expressions, "shipped, or a YAML file of them"},
          {"robot", &settings.robot, "sobi, or a URDF file with ears and arms"}};
}

std_msgs::ColorRGBA ToMessage(const Colour& colour) {
  std_msgs::ColorRGBA message;
  message.r = static_cast<float>(colour[0]) / 255;
  message.g = static_cast<float>(colour[1]) / 255;
  message.b = static_cast<float>(colour[2]) / 255;
  message.a = 1;
  return message;
}

sensor_msgs::Image ToMessage(Picture face) {
  sensor_msgs::Image image;
  image.header.stamp = ros::Time::now();
  image.header.frame_id = "led_panel";
  image.width = static_cast<std::uint32_t>(face.width);
  image.height = static_cast<std::uint32_t>(face.height);
  image.encoding = "rgb8";
  image.step = image.width * 3;
  image.data = std::move(face.rgb);
  return image;
}

double WallNow() { return ros::WallTime::now().toSec(); }

// What is drawn, lit and turned.
class Devices {
 public:
  Devices(ros::NodeHandle& node, const RobotDescription& robot, Limbs limbs)
      : limbs_(std::move(limbs)),
        image_(node.advertise<sensor_msgs::Image>("/face/image", 2, true)),
        lights_(node.advertise<coppice_msgs::Lights>("/face/lights", 2, true)),
        markers_(node.advertise<visualization_msgs::MarkerArray>("/face/light_markers", 2, true)),
        joints_(node.advertise<sensor_msgs::JointState>("/joint_states", 2)),
        tf_(node.advertise<tf2_msgs::TFMessage>("/tf", 2)) {
    for (const JointOnRobot& joint : limbs_.joints()) {
      mounts_.push_back(
          *std::find_if(robot.frames().begin(), robot.frames().end(),
                        [&](const FrameOnRobot& f) { return f.name == joint.frame; }));
    }
  }

  void Show(const Appearance& appearance, double since) {
    ShowFace(FaceAt(appearance, since));
    ShowLights(LightsAt(appearance, since));
    limbs_.Move(LimbsAt(appearance, since), kPeriod);
    PublishLimbs();
  }

 private:
  // A frame is painted once, however long it is shown.
  void ShowFace(const FaceFrame& frame) {
    if (&frame == shown_) return;
    shown_ = &frame;
    image_.publish(ToMessage(PaintFace(frame)));
  }

  void ShowLights(const LightStep& lights) {
    if (lights.arms == lit_.arms && lights.ears == lit_.ears && lit_.seconds > 0) return;
    lit_ = lights;
    coppice_msgs::Lights message;
    message.arms = ToMessage(lights.arms);
    message.ears = ToMessage(lights.ears);
    lights_.publish(message);
    markers_.publish(LightMarkers(lights, limbs_.joints()));
  }

  // Not twice for the same time, which tf refuses: slower than real time the clock stands between.
  void PublishLimbs() {
    const ros::Time now = ros::Time::now();
    if (now == published_) return;
    published_ = now;
    sensor_msgs::JointState state;
    tf2_msgs::TFMessage frames;
    state.header.stamp = now;
    for (std::size_t i = 0; i < mounts_.size(); ++i) {
      const JointOnRobot& joint = limbs_.joints()[i];
      const double angle = limbs_.angles()[i];
      state.name.push_back(joint.name);
      state.position.push_back(angle);
      geometry_msgs::TransformStamped& frame = frames.transforms.emplace_back();
      frame.header.stamp = state.header.stamp;
      frame.header.frame_id = mounts_[i].parent;
      frame.child_frame_id = joint.frame;
      frame.transform.translation.x = mounts_[i].position[0];
      frame.transform.translation.y = mounts_[i].position[1];
      frame.transform.translation.z = mounts_[i].position[2];
      frame.transform.rotation.x = joint.axis[0] * std::sin(angle / 2);
      frame.transform.rotation.y = joint.axis[1] * std::sin(angle / 2);
      frame.transform.rotation.z = joint.axis[2] * std::sin(angle / 2);
      frame.transform.rotation.w = std::cos(angle / 2);
    }
    joints_.publish(state);
    tf_.publish(frames);
  }

  Limbs limbs_;
  std::vector<FrameOnRobot> mounts_;  // one for each joint, level on the body
  ros::Time published_;               // 0: ROS time has not begun
  const FaceFrame* shown_ = nullptr;
  LightStep lit_{0, {}, {}};
  ros::Publisher image_, lights_, markers_, joints_, tf_;
};

class ExpressionNode {
 public:
  ExpressionNode(ExpressionTable table, const RobotDescription& robot, Limbs limbs)
      : table_(std::move(table)),
        devices_(node_, robot, std::move(limbs)),
        shown_(node_.advertise<std_msgs::String>("/face/expression", 2, true)) {
    subscribers_ = {node_.subscribe("/expression", 10, &ExpressionNode::OnWish, this),
                    node_.subscribe("/speech/state", 10, &ExpressionNode::OnSpeech, this),
                    node_.subscribe("/speech/answer", 10, &ExpressionNode::OnAnswer, this),
                    node_.subscribe("/assistance/requests", 10, &ExpressionNode::OnRequests, this)};
    timer_ = node_.createWallTimer(ros::WallDuration(kPeriod),
                                   [this](const ros::WallTimerEvent&) { Show(); });
  }

 private:
  void OnWish(const coppice_msgs::Expression& wish) {
    Expression expression{};
    if (ValueTraits<Expression>::Parse(wish.expression, expression)) {
      wishes_.Want(wish.owner, expression, WallNow(), kHeard);
    } else {
      ROS_WARN_THROTTLE(10, "%s wants the unknown expression \"%s\"", wish.owner.c_str(),
                        wish.expression.c_str());
    }
  }

  void OnSpeech(const coppice_msgs::SpeechState& state) {
    if (state.hearing) {
      wishes_.Want("ear", Expression::LISTENING, WallNow(), kHeard);
    } else {
      wishes_.Withdraw("ear");
    }
  }

  void OnAnswer(const coppice_msgs::Answer& answer) {
    if (answer.mood != coppice_msgs::Answer::UNKNOWN) return;
    const double spoken = kSadPerByte * static_cast<double>(answer.text.size());
    wishes_.Want("answer", Expression::SAD, WallNow(), std::max(kLeastSad, spoken));
  }

  void OnRequests(const coppice_msgs::HelpRequests& message) {
    const bool asks = std::any_of(
        message.requests.begin(), message.requests.end(),
        [](const auto& request) { return request.state == coppice_msgs::HelpRequest::OPEN; });
    if (asks) {
      wishes_.Want("assistance", Expression::ASKING_FOR_HELP, WallNow(), kForEver);
    } else {
      wishes_.Withdraw("assistance");
    }
  }

  void Show() {
    const double now = WallNow();
    const Expression wanted = wishes_.Shown(now);
    if (wanted != expression_ || since_ == 0) {
      expression_ = wanted;
      since_ = now;
      std_msgs::String message;
      message.data = ValueTraits<Expression>::Print(wanted);
      shown_.publish(message);
    }
    devices_.Show(table_[expression_], now - since_);
  }

  ros::NodeHandle node_;
  const ExpressionTable table_;
  Wishes wishes_;
  Devices devices_;
  Expression expression_ = Expression::NEUTRAL;
  double since_ = 0;  // wall time [s]; 0: nothing is shown yet
  ros::Publisher shown_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
};

int Fail(const std::string& problem) {
  std::fprintf(stderr, "expression: %s\n", problem.c_str());
  return 2;
}

int Run(const Settings& settings) {
  Diagnostics diagnostics;
  const std::string file =
      settings.expressions == "shipped" ? Shipped(COPPICE_EXPRESSIONS) : settings.expressions;
  ExpressionTable table = ReadExpressions(file, diagnostics);
  if (diagnostics.has_errors()) return Fail(diagnostics.ToString());
  const Expected<RobotDescription> robot =
      RobotDescription::Load(settings.robot == "sobi" ? Shipped(COPPICE_ROBOT) : settings.robot);
  if (!robot) return Fail(robot.problem());
  Expected<Limbs> limbs = Limbs::Of(*robot);
  if (!limbs) return Fail(limbs.problem());
  const ExpressionNode node(std::move(table), *robot, *std::move(limbs));
  ros::spin();
  return 0;
}

}  // namespace
}  // namespace coppice::robot::expression

int main(int argc, char** argv) {
  using namespace coppice::robot::expression;  // NOLINT: the whole program
  return coppice::robot::RunNode<Settings>(argc, argv, "expression", kHelp, Run);
}
