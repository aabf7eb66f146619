#include "robot_app/ros/visitor_feed.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "bt_core/engine/executor.h"
#include "bt_nodes/visitors/visitor_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

using leaves::Visitor;

class VisitorFeedTest : public testing::Test {
 protected:
  VisitorFeedTest() {
    auto registry = std::make_shared<Registry>();
    registry->Register<leaves::VisitorTalks>("VisitorTalks");
    Diagnostics diagnostics;
    auto project = Project::FromText(
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">"
        "<VisitorTalks visitor=\"{visitor}\"/></BehaviorTree></root>",
        "visitors", diagnostics);
    program_ = Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
    executor_.emplace(program_, clock_);
    feed_.Connect({executor_->Writer<Visitor>("visitor")});
  }
  // What the tree knows.
  Visitor Known() {
    executor_->Tick();
    return executor_->blackboard()[program_->layout.Find(kMainScope, "visitor")]
        .value.Get<Visitor>();
  }
  template <typename Message>
  bool Leads(const ros::Publisher& publisher, const Message& message,
             const std::function<bool(const Visitor&)>& to) {
    return Eventually([&] {
      publisher.publish(message);
      return to(Known());
    });
  }
  static coppice_msgs::Answer Guiding(const std::string& place) {
    coppice_msgs::Answer answer;
    answer.language = "de";
    answer.intent = "guide";
    answer.place = place;
    answer.guides = true;
    return answer;
  }
  int WantToGoTo(const std::string& place) {
    int request = 0;
    EXPECT_TRUE(Leads(answers_, Guiding(place), [&](const Visitor& visitor) {
      request = visitor.request;
      return visitor.place == place && request != 0;
    }));
    return request;
  }

  ros::NodeHandle node_;
  ros::Publisher heard_ = node_.advertise<coppice_msgs::Heard>("/speech/heard", 1);
  ros::Publisher answers_ = node_.advertise<coppice_msgs::Answer>("/speech/answer", 1);
  ros::Publisher state_ = node_.advertise<coppice_msgs::SpeechState>("/speech/state", 1);
  ros::Publisher touches_ = node_.advertise<std_msgs::Empty>("/tablet/touched", 1);
  SimulatedClock clock_{std::chrono::seconds(100)};
  std::shared_ptr<const Program> program_;
  std::optional<Executor> executor_;
  VisitorFeed feed_{node_, clock_};
};

TEST_F(VisitorFeedTest, TellsThatSomebodySpeaksButNotThatThereIsNoise) {
  coppice_msgs::Heard heard;
  heard.text = "hello";
  EXPECT_TRUE(Leads(heard_, heard, [&](const Visitor& v) { return v.heard == clock_.Now(); }));
}

TEST_F(VisitorFeedTest, TellsWhichLanguageIsSpokenBeforeAnybodyHasAskedAnything) {
  coppice_msgs::SpeechState state;
  state.language = "de";
  EXPECT_TRUE(Leads(state_, state, [](const Visitor& v) { return v.language == "de"; }));
}

TEST_F(VisitorFeedTest, CountsTouches) {
  EXPECT_TRUE(Leads(touches_, std_msgs::Empty(), [](const Visitor& v) { return v.touches > 0; }));
}

TEST_F(VisitorFeedTest, TellsWhereAVisitorWantsToBeLed) {
  WantToGoTo("office");
  const Visitor visitor = Known();
  EXPECT_EQ(visitor.language, "de");
  EXPECT_EQ(visitor.asked, clock_.Now());
  EXPECT_EQ(visitor.heard, Time{}) << "there is nothing more to say";
}

TEST_F(VisitorFeedTest, ForgetsAWishThatIsSettled) {
  const int request = WantToGoTo("office");
  feed_.Settle(request - 1, "arrived");
  EXPECT_EQ(Known().request, request) << "another one";
  EXPECT_TRUE(Eventually([&] {  // what was sent more than once may come late
    feed_.Settle(Known().request, "arrived");
    return Known().request == 0;
  }));
}

TEST_F(VisitorFeedTest, ForgetsAWishThatIsTakenBack) {
  WantToGoTo("office");
  coppice_msgs::Answer cancel;
  cancel.intent = "cancel";
  EXPECT_TRUE(Leads(answers_, cancel, [](const Visitor& v) { return v.request == 0; }));
}

TEST_F(VisitorFeedTest, ANewWishIsAnotherOne) {
  const int first = WantToGoTo("office");
  EXPECT_GT(WantToGoTo("library"), first);
}

}  // namespace
}  // namespace coppice::robot::adapters
