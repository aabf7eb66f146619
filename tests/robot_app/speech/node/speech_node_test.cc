#include <actionlib/client/action_client.h>
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Ask.h>
#include <coppice_msgs/HearFile.h>
#include <coppice_msgs/SpeakAction.h>
#include <coppice_msgs/SpeechState.h>
#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>

#include "bt_core/base/read_file.h"
#include "robot_app/common/child_process.h"
#include "robot_app/speech/mouth/synthesizer.h"
#include "robot_app/speech/sound/wav_file.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::speech {
namespace {

using Client = actionlib::ActionClient<coppice_msgs::SpeakAction>;

std::string LogOf(const TemporaryFolder& folder) {
  Diagnostics diagnostics;
  return coppice::ReadFile(folder.Path("log"), diagnostics).value_or("");
}

// The program with the shipped sample, its sound in files.
class SpeechNodeTest : public testing::Test {
 protected:
  void SetUp() override {
    program_ = ChildProcess(
        {BinaryFolder() + "/bin/coppice-speech", "_knowledge:=" + folder_.Path("campus.db"),
         "_site:=sample", "_output:=folder:" + folder_.Path("said"),
         "_places:=" + SourceFolder() + "/robot_app/config/sites/institute/places.yaml"},
        folder_.Path("log"));
    ASSERT_TRUE(Eventually([&] {
      return client_.isServerConnected() && ros::service::exists("/speech/hear_file", false);
    })) << LogOf(folder_);
  }

  static coppice_msgs::SpeakGoal Goal(const std::string& text, std::uint8_t priority = 100) {
    coppice_msgs::SpeakGoal goal;
    goal.text = text;
    goal.priority = priority;
    return goal;
  }
  Client::GoalHandle Send(const coppice_msgs::SpeakGoal& goal) {
    return client_.sendGoal(
        goal, [](const Client::GoalHandle&) {},
        [this](const Client::GoalHandle&, const coppice_msgs::SpeakFeedbackConstPtr&) {
          ++words_;
        });
  }
  static bool IsDone(const Client::GoalHandle& goal) {
    return Eventually([&] { return goal.getCommState() == actionlib::CommState::DONE; });
  }

  // Of the one that is answered while it stands there, x [m] along the corridor.
  std::string NearestOfficeFrom(double x) {
    tf2_msgs::TFMessage message;
    for (const auto& [parent, child] : {std::pair("map", "odom"), std::pair("odom", "base_link")}) {
      geometry_msgs::TransformStamped& frame = message.transforms.emplace_back();
      frame.header.frame_id = parent;
      frame.child_frame_id = child;
      frame.transform.translation.x = std::string(child) == "odom" ? x : 0;
      frame.transform.rotation.w = 1;
    }
    const ros::WallTimer timer =
        node_.createWallTimer(ros::WallDuration(0.02), [&](const ros::WallTimerEvent&) {
          for (auto& frame : message.transforms) frame.header.stamp = ros::Time::now();
          tf_.publish(message);
        });
    coppice_msgs::Ask ask;
    ask.request.text = "where is the nearest office";
    EXPECT_TRUE(ros::service::call("/speech/ask", ask));
    return ask.response.answer.place;
  }

  coppice_msgs::Answer Asked(const std::string& text, const std::string& who) {
    coppice_msgs::Ask ask;
    ask.request.text = text;
    ask.request.who = who;
    EXPECT_TRUE(ros::service::call("/speech/ask", ask));
    return ask.response.answer;
  }

  // In a file, as if it were said now.
  void SpeakTo(const std::string& text, const std::string& who) {
    const Sound said = Synthesizer().Speak(text, {"en-us+m6", 140})->sound;
    ASSERT_TRUE(WriteWav(folder_.Path("question.wav"), said));
    coppice_msgs::HearFile hear;
    hear.request.path = folder_.Path("question.wav");
    hear.request.who = who;
    ASSERT_TRUE(ros::service::call("/speech/hear_file", hear));
    EXPECT_TRUE(hear.response.ok) << hear.response.message;
  }

  TemporaryFolder folder_;
  ros::NodeHandle node_;
  ros::Publisher tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 10);
  Client client_{node_, "/speak"};
  std::atomic<int> words_{0};
  ChildProcess program_;
};

TEST_F(SpeechNodeTest, AGoalSucceedsWhenItsSoundHasBeenPlayed) {
  const ros::WallTime begin = ros::WallTime::now();
  const auto goal = Send(Goal("Please follow me."));
  ASSERT_TRUE(IsDone(goal));
  EXPECT_EQ(goal.getResult()->outcome, coppice_msgs::SpeakResult::PLAYED);
  EXPECT_EQ(words_, 3);
  const auto sound = ReadWav(folder_.Path("said/0001.wav"));
  ASSERT_TRUE(sound) << sound.problem();
  EXPECT_GE((ros::WallTime::now() - begin).toSec(), sound->seconds());
}

TEST_F(SpeechNodeTest, ACancelledGoalSaysSo) {
  Latest<coppice_msgs::SpeechState> state(node_, "/speech/state");
  auto goal = Send(Goal("This is long enough to be stopped before anybody has heard all of it."));
  ASSERT_TRUE(Eventually([&] { return state.get() && state.get()->speaking; }));
  goal.cancel();
  ASSERT_TRUE(IsDone(goal));
  EXPECT_EQ(goal.getResult()->outcome, coppice_msgs::SpeakResult::CANCELLED);
}

TEST_F(SpeechNodeTest, WhatIsTooLongIsNotTaken) {
  coppice_msgs::SpeakGoal language = Goal("Hello.");
  language.language = std::string(100'000, 'x');
  for (const coppice_msgs::SpeakGoal& goal : {Goal(std::string(100'000, 'x')), language}) {
    const auto sent = Send(goal);
    ASSERT_TRUE(IsDone(sent));
    EXPECT_EQ(sent.getTerminalState(), actionlib::TerminalState::REJECTED);
  }
  EXPECT_TRUE(IsDone(Send(Goal("Hello."))));
}

TEST_F(SpeechNodeTest, WhatIsMoreUrgentCutsWhatIsBeingSaid) {
  const auto chat = Send(Goal("All is quiet on this floor, and nobody needs to worry.", 0));
  const auto urgent = Send(Goal("Careful!", 200));
  ASSERT_TRUE(IsDone(chat));
  ASSERT_TRUE(IsDone(urgent));
  EXPECT_EQ(chat.getResult()->outcome, coppice_msgs::SpeakResult::CUT);
  EXPECT_EQ(urgent.getResult()->outcome, coppice_msgs::SpeakResult::PLAYED);
}

TEST_F(SpeechNodeTest, AnswersWhatIsAskedInWriting) {
  coppice_msgs::Ask ask;
  ask.request.text = "take me to the library";
  ask.request.who = "anna";
  ask.request.source = coppice_msgs::Heard::TABLET;
  Latest<coppice_msgs::Answer> told(node_, "/speech/answer");
  ASSERT_TRUE(Eventually([&] { return told.is_connected(); }));
  ASSERT_TRUE(ros::service::call("/speech/ask", ask));
  const coppice_msgs::Answer& answer = ask.response.answer;
  EXPECT_EQ(answer.intent, "guide");
  EXPECT_EQ(answer.slots, std::vector<std::string>{"place=library"});
  EXPECT_EQ(answer.heard.who, "anna");
  EXPECT_TRUE(Eventually([&] { return told.get() && told.get()->text == answer.text; }));
}

TEST_F(SpeechNodeTest, WhatNobodyAsksInOneBreathIsNotAnswered) {
  coppice_msgs::Ask ask;
  ask.request.text = std::string(10 << 20, 'x');
  EXPECT_FALSE(ros::service::call("/speech/ask", ask));
  EXPECT_NE(Asked("where is the library", "").place, "");
}

TEST_F(SpeechNodeTest, TheNearestPlaceIsThatFromWhereTheRobotIs) {
  EXPECT_EQ(NearestOfficeFrom(8), "office_105");
  EXPECT_EQ(NearestOfficeFrom(24), "office_103");
}

TEST_F(SpeechNodeTest, AQuestionThatIsAskedBackIsGoneForSomebodyElse) {
  coppice_msgs::Ask ask;
  ask.request.text = "where is the office of Weber";
  ask.request.who = "anna";
  ASSERT_TRUE(ros::service::call("/speech/ask", ask));
  EXPECT_EQ(ask.response.answer.mood, coppice_msgs::Answer::ASKING);
  ask.request.text = "the first one";
  ask.request.who = "ben";
  ASSERT_TRUE(ros::service::call("/speech/ask", ask));
  EXPECT_NE(ask.response.answer.intent, "find_person");
}

TEST_F(SpeechNodeTest, AQuestionThatIsAskedBackIsAnsweredAloud) {
  const coppice_msgs::Answer asked = Asked("where is the office of Weber", "anna");
  ASSERT_EQ(asked.choices.size(), 2U);
  EXPECT_EQ(asked.choices[1].label, "Dr. Paul Weber");
  Latest<coppice_msgs::Answer> answer(node_, "/speech/answer");
  ASSERT_TRUE(Eventually([&] { return answer.is_connected(); }));
  SpeakTo("the second one", "anna");
  ASSERT_TRUE(Eventually([&] { return answer.get() != nullptr; }));
  EXPECT_EQ(answer.get()->heard.text, "the second one");
  EXPECT_EQ(answer.get()->slots, std::vector<std::string>{"person=paul_weber"});
}

TEST_F(SpeechNodeTest, WhatTheTabletAnswersEndsTheQuestion) {
  ros::Publisher tablet = node_.advertise<coppice_msgs::Answer>("/speech/answer", 1);
  ASSERT_TRUE(Eventually([&] { return tablet.getNumSubscribers() > 0; }));
  EXPECT_TRUE(Eventually([&] {  // it may come after what is said next
    Asked("where is the office of Weber", "anna");
    tablet.publish(coppice_msgs::Answer());
    return Asked("the second one", "anna").intent != "find_person";
  }));
}

TEST_F(SpeechNodeTest, ARecordingIsHeardUnderstoodAndAnsweredAloud) {
  Latest<coppice_msgs::Answer> answer(node_, "/speech/answer");
  ASSERT_TRUE(Eventually([&] { return answer.is_connected(); }));
  SpeakTo("where is the copy shop", "");
  ASSERT_TRUE(Eventually([&] { return answer.get() != nullptr; }));
  EXPECT_EQ(answer.get()->heard.text, "where is the copy shop");
  EXPECT_EQ(answer.get()->place, "copy_shop");
  EXPECT_TRUE(Eventually([&] { return ReadWav(folder_.Path("said/0001.wav")).ok(); }));
}

TEST_F(SpeechNodeTest, SmallTalkIsHeardAndAnsweredAloud) {
  Latest<coppice_msgs::Answer> answer(node_, "/speech/answer");
  ASSERT_TRUE(Eventually([&] { return answer.is_connected(); }));
  SpeakTo("who built you", "");
  ASSERT_TRUE(Eventually([&] { return answer.get() != nullptr; }));
  EXPECT_EQ(answer.get()->intent, "small_talk") << answer.get()->heard.text;
  EXPECT_EQ(answer.get()->slots, std::vector<std::string>{"topic=maker"});
  EXPECT_TRUE(Eventually([&] { return ReadWav(folder_.Path("said/0001.wav")).ok(); }));
}

TEST_F(SpeechNodeTest, WhileItSpeaksItHearsNothing) {
  Latest<coppice_msgs::SpeechState> state(node_, "/speech/state");
  Send(Goal("This is long enough to be heard by an ear that is open meanwhile."));
  ASSERT_TRUE(Eventually([&] { return state.get() && state.get()->speaking; }));
  EXPECT_FALSE(state.get()->listening);
  const Sound said = Synthesizer().Speak("where is the copy shop", {"en-us+f2", 140})->sound;
  ASSERT_TRUE(WriteWav(folder_.Path("question.wav"), said));
  coppice_msgs::HearFile hear;
  hear.request.path = folder_.Path("question.wav");
  ASSERT_TRUE(ros::service::call("/speech/hear_file", hear));
  EXPECT_FALSE(hear.response.ok);
  EXPECT_EQ(hear.response.message, "the ear is shut");
}

TEST_F(SpeechNodeTest, WhoTouchesTheTabletInGermanIsSpokenToInGerman) {
  Latest<coppice_msgs::SpeechState> state(node_, "/speech/state");
  ros::Publisher tablet = node_.advertise<coppice_msgs::Answer>("/speech/answer", 1);
  EXPECT_TRUE(Eventually([&] { return state.get() && state.get()->language == "en"; }));
  coppice_msgs::Answer answer;
  answer.language = "de";
  EXPECT_TRUE(Eventually([&] {
    tablet.publish(answer);
    return state.get()->language == "de";
  }));
  EXPECT_EQ(Asked("wo ist die Bibliothek", "").language, "de");
}

TEST(SpeechProgram, SpeaksTheLanguageOfThePlaceWithWhoHasSaidNothing) {
  TemporaryFolder folder;
  ros::NodeHandle node;
  Latest<coppice_msgs::SpeechState> state(node, "/speech/state");
  ChildProcess program(
      {BinaryFolder() + "/bin/coppice-speech", "_knowledge:=" + folder.Path("campus.db"),
       "_site:=sample", "_language:=de", "_output:=none"},
      folder.Path("log"));
  EXPECT_TRUE(Eventually([&] { return state.get() && state.get()->language == "de"; }))
      << LogOf(folder);
  ros::param::del("/speech/language");  // which would outlive it
}

TEST(SpeechProgram, AnOutputThatIsNoneIsSaidAtTheStart) {
  TemporaryFolder folder;
  ChildProcess program({BinaryFolder() + "/bin/coppice-speech", "_output:=loud"},
                       folder.Path("log"));
  ASSERT_TRUE(Eventually([&] { return !program.IsRunning(); }));
  EXPECT_EQ(program.exit_status(), 2);
  EXPECT_NE(LogOf(folder).find("~output must be none, folder:PATH or alsa:DEVICE, not \"loud\""),
            std::string::npos);
  ros::param::del("/speech/output");  // which would outlive it
}

}  // namespace
}  // namespace coppice::robot::speech
