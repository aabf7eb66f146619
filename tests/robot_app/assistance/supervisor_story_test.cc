// A request from its message to the all-clear: the robot asks, a person opens the link in Chromium,
// drives by touch and by mouse, says where the robot is, and that it is fixed. Simulated robot,
// real programs, real browser.
#include <coppice_msgs/AskForHelp.h>
#include <coppice_msgs/Health.h>
#include <coppice_msgs/HelpRequests.h>
#include <coppice_msgs/ProcessStates.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "robot_app/common/child_process.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/assistance/local_server.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"

namespace coppice::robot::assistance {
namespace {

using coppice_msgs::HelpRequest;
using nlohmann::json;

class Story : public testing::Test {
 protected:
  Story() {
    ros::param::set("/use_sim_time", true);  // before anybody starts
    Start("coppice-simulator", {"_start:=8 -0.3 0", "_speed:=1"});
    Start("coppice-simulated-cameras", {});
    Start("coppice-velocity-mux", {});
    std::ofstream(folder_ + "supervisors.yaml") << Config();
    Start("coppice-assistance", {"--config", folder_ + "supervisors.yaml", "--live-port", "0"});
    PublishState();
  }

  std::string Config() const {
    return "robot: Sobi\n"
           "channels: [{name: hook, kind: webhook, url: \"" +
           people_.url() +
           "\"}]\n"
           "supervisors: [{name: Ada, reach: [{channel: hook, to: ada}]},\n"
           "              {name: Ben, reach: [{channel: hook, to: ben}]}]\n"
           "patience: {next: 1, remind: 3000, settle: 0}\n"
           "page:\n"
           "  port: " +
           std::to_string(processes::FreePort()) +
           "\n"
           "  cameras: [{name: front, topic: /camera/front/color/image_raw/compressed},\n"
           "            {name: rear, topic: /camera/rear/color/image_raw/compressed}]\n";
  }

  void Start(const std::string& program, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), BinaryFolder() + "/bin/" + program);
    programs_.emplace_back(arguments, folder_ + program + ".log");
  }

  // What monitors and process supervisor would say.
  void PublishState() {
    coppice_msgs::Health health;
    health.entries.resize(2);
    health.entries[0].monitor = "topic";
    health.entries[0].subject = "/scan";
    health.entries[0].level = coppice_msgs::HealthEntry::WARN;
    health.entries[0].message = "8.1 Hz, expected at least 9 Hz";
    health.entries[1].monitor = "node";
    health.entries[1].subject = "/navigation";
    health_.publish(health);
    coppice_msgs::ProcessStates states;
    states.configuration = "operating";
    for (const char* const name : {"base", "cameras", "navigation"}) {
      coppice_msgs::ProcessState process;
      process.name = name;
      process.state = coppice_msgs::ProcessState::READY;
      states.processes.push_back(process);
    }
    processes_.publish(states);
  }

  std::vector<json> Messages(const std::string& kind) {
    std::vector<json> messages;
    for (const HttpServer::Request& request : people_.requests()) {
      const json body = json::parse(request.body());
      if (body.at("kind") == kind) messages.push_back(body);
    }
    return messages;
  }

  bool Ask(const std::string& question) {
    coppice_msgs::AskForHelp service;
    service.request.subject = "navigation";
    service.request.question = question;
    return Eventually([&] { return ros::service::call("/assistance/ask", service); }, 30);
  }

  const std::string folder_ = testing::TempDir() + "story_" + std::to_string(getpid()) + "_";
  HttpServer people_;
  std::vector<ChildProcess> programs_;
  ros::NodeHandle node_;
  ros::Publisher health_ = node_.advertise<coppice_msgs::Health>("/monitoring", 1, true);
  ros::Publisher processes_ = node_.advertise<coppice_msgs::ProcessStates>("/processes", 1, true);
};

// What comes of a topic, for another thread to look at.
template <class Message>
class Heard {
 public:
  Heard(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe<Message>(
            topic, 1000, [this](const boost::shared_ptr<Message const>& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              messages_.push_back(*message);
            })) {}
  std::vector<Message> messages() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }

 private:
  std::mutex mutex_;
  std::vector<Message> messages_;
  ros::Subscriber subscriber_;
};

TEST_F(Story, APersonHelpsTheRobotFromTheMessageToTheAllClear) {
  Heard<geometry_msgs::Twist> base(node_, "/cmd_vel");
  Heard<geometry_msgs::PoseWithCovarianceStamped> position(node_, "/initialpose");
  Heard<HelpRequest> answers(node_, "/assistance/answers");
  ASSERT_TRUE(Ask("A pallet stands in the corridor."));
  ASSERT_TRUE(people_.WaitFor(2));
  const std::vector<json> questions = Messages("question");
  ASSERT_EQ(questions.size(), 2u);
  EXPECT_EQ(questions[0].at("to"), "ada");

  ChildProcess browser(
      {"/usr/bin/python3", SourceFolder() + "/tests/robot_app/assistance/supervisor_story.py",
       questions[0].at("link"), BinaryFolder() + "/tests/supervisor_story"},
      folder_ + "browser.log");
  ASSERT_TRUE(Eventually([&] { return !browser.IsRunning(); }, 500));
  std::ifstream log(folder_ + "browser.log");
  ASSERT_EQ(browser.exit_status(), 0) << log.rdbuf();

  double fastest = 0;
  double slowest = 0;
  for (const geometry_msgs::Twist& twist : base.messages()) {
    fastest = std::max(fastest, twist.linear.x);
    slowest = std::min(slowest, twist.linear.x);
  }
  EXPECT_GT(fastest, 0.1);
  EXPECT_LE(fastest, 0.4);
  EXPECT_LT(slowest, -0.05);
  ASSERT_EQ(position.messages().size(), 1u);
  EXPECT_NEAR(position.messages()[0].pose.pose.orientation.z, std::sqrt(0.5), 0.03);
  ASSERT_TRUE(Eventually([&] { return !answers.messages().empty(); }));
  EXPECT_EQ(answers.messages()[0].answered_by, "Ada");
  EXPECT_EQ(answers.messages()[0].state, HelpRequest::FIXED);
  ASSERT_TRUE(Eventually([&] { return !Messages("all-clear").empty(); }));
  EXPECT_EQ(Messages("all-clear")[0].at("to"), "ben");
}

}  // namespace
}  // namespace coppice::robot::assistance
