#include "robot_app/ros/people_feed.h"

#include <gtest/gtest.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <limits>

#include "bt_core/engine/executor.h"
#include "bt_nodes/people/people_leaves.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"

namespace coppice::robot::adapters {
namespace {

class PeopleFeedTest : public testing::Test {
 protected:
  void Run(const std::string& attributes) {
    auto registry = std::make_shared<Registry>();
    registry->Register<leaves::CountPeople>("CountPeople");
    Diagnostics diagnostics;
    auto project = Project::FromText(
        "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\">"
        "<CountPeople " +
            attributes + "/></BehaviorTree></root>",
        "people", diagnostics);
    program_ = Compile(std::make_shared<const Project>(*std::move(project)), registry, diagnostics);
    ASSERT_TRUE(program_) << diagnostics.ToString();
    executor_.emplace(program_, clock_);
    feed_.emplace(node_, std::vector{executor_->Writer<leaves::PeopleView>("people")}, clock_);
  }
  // What a tree knows of `people`; nothing yet.
  const leaves::PeopleView* View() {
    executor_->Tick();
    const Value& value = executor_->blackboard()[program_->layout.Find(kMainScope, "people")].value;
    return value.has_value() ? &value.Get<leaves::PeopleView>() : nullptr;
  }
  static coppice_msgs::People Somebody(double x, double y) {
    coppice_msgs::People people;
    people.header.frame_id = "odom";
    people.people.resize(1);
    people.people[0].id = 7;
    people.people[0].position.x = x;
    people.people[0].position.y = y;
    people.people[0].velocity.x = 0.6;
    people.people[0].velocity.y = 0.8;
    people.people[0].mask = coppice_msgs::Person::WITHOUT_MASK;
    return people;
  }
  // The robot stands at (1, 2) and looks along y.
  void PlaceRobot() {
    geometry_msgs::TransformStamped place;
    place.header.frame_id = "odom";
    place.header.stamp = ros::Time::now();
    place.child_frame_id = "base_link";
    place.transform.translation.x = 1;
    place.transform.translation.y = 2;
    place.transform.rotation.z = place.transform.rotation.w = std::sqrt(0.5);
    tf_.sendTransform(place);
  }

  ros::NodeHandle node_;
  tf2_ros::StaticTransformBroadcaster tf_;
  ros::Publisher people_ = node_.advertise<coppice_msgs::People>("/people", 1);
  SimulatedClock clock_;
  std::shared_ptr<const Program> program_;
  std::optional<Executor> executor_;
  std::optional<PeopleFeed> feed_;
};

TEST_F(PeopleFeedTest, TellsWhereSomebodyIsAsSeenFromTheRobot) {
  Run("people=\"{people}\"");
  PlaceRobot();
  clock_.Advance(std::chrono::seconds(5));
  const leaves::PeopleView* view = nullptr;
  ASSERT_TRUE(Eventually([&] {
    people_.publish(Somebody(1, 5));
    view = View();
    return view != nullptr;
  }));
  ASSERT_EQ(view->people.size(), 1U);
  EXPECT_DOUBLE_EQ(view->people[0].x, 3);
  EXPECT_DOUBLE_EQ(view->people[0].y, 0);
  EXPECT_DOUBLE_EQ(view->people[0].speed, 1);
  EXPECT_EQ(view->people[0].mask, leaves::Mask::kWithout);
  EXPECT_EQ(view->stamp, clock_.Now());
}

TEST_F(PeopleFeedTest, WhoIsNowhereIsLeftOut) {
  Run("people=\"{people}\"");
  PlaceRobot();
  coppice_msgs::People people = Somebody(1, 5);
  people.people.push_back(people.people[0]);
  people.people[1].position.x = std::numeric_limits<double>::quiet_NaN();
  ASSERT_TRUE(Eventually([&] {
    people_.publish(people);
    return View() != nullptr;
  }));
  EXPECT_EQ(View()->people.size(), 1U);
}

TEST_F(PeopleFeedTest, WhereNoTreeUsesTheKeyNobodyListens) {
  Run("");
  EXPECT_EQ(people_.getNumSubscribers(), 0U);
}

}  // namespace
}  // namespace coppice::robot::adapters
