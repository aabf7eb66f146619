// A visitor asks the robot to lead him, follows or stays behind: real simulator, navigation, trees
// and adapters over ROS, at three times real time. The visitor and what perception tells of him are
// played.
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/People.h>
#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

#include "robot_app/common/child_process.h"
#include "robot_app/common/ros_support.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

// Stands before the robot, and walks behind it as soon as it has driven past him.
class Visitor {
 public:
  explicit Visitor(ros::NodeHandle& node)
      : people_(node.advertise<coppice_msgs::People>("/people", 1)),
        truth_(node.subscribe("/simulation/truth", 1, &Visitor::OnRobot, this)) {}

  void StayBehind() {
    const std::lock_guard lock(mutex_);
    follows_ = false;
  }
  Pose2D robot() const {
    const std::lock_guard lock(mutex_);
    return robot_;
  }

 private:
  static constexpr double kGap = 1.2;  // m

  void OnRobot(const geometry_msgs::PoseStamped& message) {
    const std::lock_guard lock(mutex_);
    robot_ = ToPose2D(message.pose);
    if (!has_come_) place_ = {robot_.x + 1, robot_.y};
    has_come_ = true;
    const double dx = robot_.x - place_.x, dy = robot_.y - place_.y;
    const double distance = std::hypot(dx, dy);
    if (follows_ && distance > kGap) {
      const double part = (distance - kGap) / distance;
      place_ = {place_.x + part * dx, place_.y + part * dy};
    }
    coppice_msgs::People people;
    people.header.frame_id = "map";
    people.header.stamp = message.header.stamp;
    coppice_msgs::Person& person = people.people.emplace_back();
    person.id = 7;
    person.position.x = place_.x;
    person.position.y = place_.y;
    person.known_for = 10;
    people_.publish(people);
  }

  mutable std::mutex mutex_;
  Pose2D robot_;
  Point2D place_;
  bool has_come_ = false;
  bool follows_ = true;
  ros::Publisher people_;
  ros::Subscriber truth_;
};

class VisitorTest : public testing::Test {
 protected:
  VisitorTest() {
    ros::param::set("/use_sim_time", true);
    Start("coppice-simulator", {"_start:=8 0 0", "_speed:=3"});
    Start("coppice-navigation", {});
    const std::string idle = Name("idle.xml");
    std::ofstream(idle) << "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Idle\">"
                           "<Sleep msec=\"100000000\"/></BehaviorTree></root>";
    Start("coppice-robot",
          {"--application", SourceFolder() + "/tests/system/trees/lead.xml", "--monitor", idle,
           "--places", SourceFolder() + "/robot_app/config/sites/institute/places.yaml",
           "--live-port", "0"});
  }
  void Start(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BinaryFolder() + "/bin/" + program);
    programs_.emplace_back(arguments, Name(program + ".log"));
  }
  static std::string Name(const std::string& file) {
    return testing::TempDir() + "visitor_" + std::to_string(getpid()) + "_" + file;
  }
  // Until the robot has set off. As long as it does not know where it is, it knows no way.
  bool AskToBeLed(const std::string& place) {
    coppice_msgs::Answer answer;
    answer.language = "en";
    answer.intent = "guide";
    answer.place = place;
    answer.guides = true;
    if (!Eventually([&] { return answers_.getNumSubscribers() > 0; })) return false;
    answers_.publish(answer);
    return Eventually([&] {
      if (Ended("blocked")) answers_.publish(answer);
      return std::abs(visitor_.robot().x - 8) > 1;
    });
  }
  // Tells it once.
  bool Ended(const std::string& outcome) {
    const std::lock_guard lock(mutex_);
    const bool has_ended = outcome_ == outcome;
    if (has_ended) outcome_.clear();
    return has_ended;
  }
  bool Ends(const std::string& outcome) {
    return Eventually([&] { return Ended(outcome); });
  }

  ros::NodeHandle node_;
  std::vector<ChildProcess> programs_;
  Visitor visitor_{node_};
  ros::Publisher answers_ = node_.advertise<coppice_msgs::Answer>("/speech/answer", 1);
  std::mutex mutex_;
  std::string outcome_;
  ros::Subscriber outcomes_ = node_.subscribe<std_msgs::String>(
      "/visitors/outcome", 10, [this](const std_msgs::String::ConstPtr& message) {
        const std::lock_guard lock(mutex_);
        outcome_ = message->data;
      });
};

TEST_F(VisitorTest, IsLedToTheOfficeThatHeAskedFor) {
  ASSERT_TRUE(AskToBeLed("office_103"));
  ASSERT_TRUE(Ends("arrived"));
  EXPECT_LT(Distance(visitor_.robot(), Pose2D{24, 3.6, 0}), 0.5);
}

TEST_F(VisitorTest, WhoStaysBehindIsWaitedForAndThenLeft) {
  ASSERT_TRUE(AskToBeLed("hall"));
  visitor_.StayBehind();
  ASSERT_TRUE(Ends("lost"));
  EXPECT_LT(visitor_.robot().x, 30) << "it has waited where it lost him";
}

}  // namespace
}  // namespace coppice::robot
