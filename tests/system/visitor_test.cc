// A visitor of the whole robot, in real time: he comes, asks by voice, answers a question back, is
// led to the place, and goes. All sensors see him, and all that he says is heard.
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/HearFile.h>
#include <coppice_msgs/People.h>
#include <coppice_msgs/SimulatedWorld.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_msgs/String.h>

#include <cmath>
#include <memory>

#include "robot_app/speech/mouth/synthesizer.h"
#include "robot_app/speech/sound/wav_file.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/support/temporary_folder.h"
#include "tests/system/robot_rig.h"

namespace coppice::robot {
namespace {

constexpr double kPatience = 60;     // s, wall: of an answer
constexpr double kLongest = 400;     // s, wall: of the way
constexpr char kVisitor[] = "anna";  // who walks to and fro in the corridor
constexpr std::size_t kPlace = 0;    // hers among the people of the floor
constexpr char kVoice[] = "en-us+klatt";

class VisitorStory : public testing::Test {
 protected:
  VisitorStory() : rig_(Options()) {}

  // In the corridor, on its patrol, some metres from the office.
  static RigOptions Options() {
    RigOptions options;
    options.name = "visitor";
    options.start = "15 0 3.1416";
    options.variables = {{"speed", "1"}, {"seed", "16"}, {"perception", "yes"}};
    // Who is led is followed by the lidar; the cameras of people_test.cc would take a core.
    options.edits = {{"robot.yaml",
                      "\"${bin}/coppice-camera\"]\n    enabled: \"${perception:-yes}\"",
                      "\"${bin}/coppice-camera\"]\n    enabled: no"}};
    return options;
  }

  // Until it is heard: while it speaks its ear is shut.
  void Say(const std::string& text) {
    const auto said = speech::Synthesizer().Speak(text, {kVoice, 140});
    ASSERT_TRUE(said) << said.problem();
    ASSERT_TRUE(speech::WriteWav(folder_.Path("said.wav"), said->sound));
    coppice_msgs::HearFile hear;
    hear.request.path = folder_.Path("said.wav");
    hear.request.who = kVisitor;
    EXPECT_TRUE(Eventually(
        [&] { return ros::service::call("/speech/hear_file", hear) && hear.response.ok; },
        kPatience))
        << hear.response.message;
  }

  // What it answers to that.
  coppice_msgs::Answer Answered(const std::string& text) {
    Latest<coppice_msgs::Answer> answer(*node_, "/speech/answer");
    EXPECT_TRUE(Eventually([&] { return answer.is_connected(); }, kPatience));
    Say(text);
    EXPECT_TRUE(Eventually([&] { return answer.get() != nullptr; }, kPatience));
    return answer.get() ? *answer.get() : coppice_msgs::Answer();
  }

  // How far she is from the robot [m].
  static double DistanceOfVisitor(const coppice_msgs::SimulatedWorld& world) {
    const coppice_msgs::SimulatedPerson& visitor = world.people.at(kPlace);
    return std::hypot(visitor.x - world.robot.x, visitor.y - world.robot.y);
  }
  // Whether she is seen.
  static bool IsSeen(const coppice_msgs::People& people) {
    for (const coppice_msgs::Person& person : people.people) {
      if (std::hypot(person.position.x, person.position.y) < 2.5) return true;
    }
    return false;
  }

  RobotRig rig_;
  TemporaryFolder folder_;
  std::unique_ptr<ros::NodeHandle> node_;
};

TEST_F(VisitorStory, AsksByVoiceAnswersAQuestionBackIsLedAndGoes) {
  ASSERT_TRUE(rig_.Start());
  node_ = std::make_unique<ros::NodeHandle>();
  Latest<coppice_msgs::People> people(*node_, "/people");
  Latest<coppice_msgs::SimulatedWorld> world(*node_, "/simulation/world");
  Latest<std_msgs::String> outcome(*node_, "/visitors/outcome");

  ASSERT_TRUE(rig_.Inject("follow_robot", kVisitor));
  ASSERT_TRUE(Eventually([&] { return people.get() && IsSeen(*people.get()); }, kLongest))
      << "she comes, and is seen";

  const coppice_msgs::Answer question = Answered("take me to Weber");
  ASSERT_EQ(question.mood, coppice_msgs::Answer::ASKING) << question.heard.text;
  ASSERT_EQ(question.choices.size(), 2U) << question.text;

  const coppice_msgs::Answer answer = Answered("the first one");
  ASSERT_TRUE(answer.guides) << answer.heard.text << ": " << answer.text;
  EXPECT_EQ(answer.place, "office_101");

  ASSERT_TRUE(Eventually([&] { return outcome.get() != nullptr; }, kLongest));
  EXPECT_EQ(outcome.get()->data, "arrived");
  EXPECT_LT(DistanceOfVisitor(*world.get()), 4) << "she is there, too";

  ASSERT_TRUE(rig_.Inject("leave_robot", kVisitor));
  EXPECT_TRUE(Eventually([&] { return DistanceOfVisitor(*world.get()) > 4.5; }, kLongest))
      << "she has gone";
}

}  // namespace
}  // namespace coppice::robot
