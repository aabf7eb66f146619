#include "robot_app/common/robot_description.h"

#include <tinyxml2.h>
#include <urdf_model/link.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/read_file.h"

namespace coppice::robot {
namespace {

constexpr char kBase[] = "base_link";
constexpr std::size_t kLongest = 1 << 20;  // bytes
constexpr double kLevel = 1e-6;            // rad

FrameOnRobot FrameOf(const urdf::Link& link) {
  const urdf::Joint& joint = *link.parent_joint;
  const urdf::Pose& pose = joint.parent_to_joint_origin_transform;
  return {link.name,
          joint.parent_link_name,
          {pose.position.x, pose.position.y, pose.position.z},
          {pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w},
          joint.type == urdf::Joint::FIXED};
}

void AddChildren(const urdf::Link& link, std::vector<FrameOnRobot>& frames) {
  for (const auto& child : link.child_links) {
    frames.push_back(FrameOf(*child));
    AddChildren(*child, frames);
  }
}

std::vector<JointOnRobot> JointsOf(const urdf::ModelInterface& model) {
  std::vector<JointOnRobot> joints;
  for (const auto& [name, joint] : model.joints_) {
    if (joint->type != urdf::Joint::REVOLUTE || !joint->limits) continue;
    joints.push_back({name,
                      joint->child_link_name,
                      {joint->axis.x, joint->axis.y, joint->axis.z},
                      joint->limits->lower,
                      joint->limits->upper,
                      joint->limits->velocity});
  }
  return joints;
}

template <typename Part>
const urdf::Cylinder* CylinderOf(const Part& part) {
  if (!part || !part->geometry || part->geometry->type != urdf::Geometry::CYLINDER) return nullptr;
  return static_cast<const urdf::Cylinder*>(part->geometry.get());
}

// The parser of liburdfdom follows elements within elements until its stack ends, and takes seconds
// before; this one has a limit, and knows the line.
Outcome CheckXml(const std::string& text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) return {};
  return Problem{std::to_string(document.ErrorLineNum()) +
                 ": no robot description (URDF): " + document.ErrorName()};
}

// The yaw of a rotation about z alone.
std::optional<double> LevelYaw(const std::array<double, 4>& q) {
  if (std::hypot(q[0], q[1]) > kLevel) return std::nullopt;
  return 2 * std::atan2(q[2], q[3]);
}

}  // namespace

Expected<RobotDescription> RobotDescription::Load(const std::string& file) {
  Diagnostics diagnostics;
  std::optional<std::string> text = ReadFile(file, diagnostics, kLongest);
  if (!text) return Problem{ToString(diagnostics.all().front())};
  if (const Outcome xml = CheckXml(*text); !xml) return Problem{file + ":" + xml.problem()};
  const auto problem = [&](const std::string& what) { return Problem{file + ": " + what}; };
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(*text);
  if (!model || !model->getRoot()) return problem("no robot description (URDF)");
  const urdf::Link& base = *model->getRoot();
  if (base.name != kBase) {
    return problem("the link that all others hang on is \"" + base.name +
                   "\", expected \"base_link\"");
  }
  const urdf::Cylinder* const body = CylinderOf(base.collision);
  if (!body) return problem("base_link has no collision that is a cylinder");

  RobotDescription robot;
  AddChildren(base, robot.frames_);
  robot.joints_ = JointsOf(*model);
  robot.radius_ = body->radius;
  robot.height_ = body->length;
  const urdf::LinkConstSharedPtr left = model->getLink("left_wheel");
  const urdf::LinkConstSharedPtr right = model->getLink("right_wheel");
  const urdf::Cylinder* const wheel = left ? CylinderOf(left->visual) : nullptr;
  if (!wheel || !right) return problem("no left_wheel and right_wheel that are cylinders");
  robot.wheel_diameter_ = 2 * wheel->radius;
  robot.track_ = std::abs(FrameOf(*left).position[1] - FrameOf(*right).position[1]);
  robot.text_ = std::move(*text);
  return robot;
}

Expected<Mount> RobotDescription::MountOf(const std::string& frame) const {
  Mount mount;
  std::string name = frame;
  while (name != kBase) {
    const auto found = std::find_if(frames_.begin(), frames_.end(),
                                    [&](const FrameOnRobot& f) { return f.name == name; });
    if (found == frames_.end()) {
      std::vector<std::string> names;
      for (const FrameOnRobot& f : frames_) names.push_back(f.name);
      const std::string hint = DidYouMean(frame, names);
      return Problem{"the robot has no frame \"" + frame + "\"" +
                     (hint.empty() ? "" : " (" + hint + ")")};
    }
    const std::optional<double> yaw = LevelYaw(found->rotation);
    if (!found->is_fixed || !yaw) {
      return Problem{"\"" + frame + "\" " + (yaw ? "moves" : "does not stand level") + " on \"" +
                     found->parent + "\""};
    }
    mount.pose = Compose({found->position[0], found->position[1], *yaw}, mount.pose);
    mount.height += found->position[2];
    name = found->parent;
  }
  return mount;
}

}  // namespace coppice::robot
