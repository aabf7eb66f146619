#include "robot_app/ros/ros_interaction.h"

#include <gtest/gtest.h>
#include <std_msgs/String.h>

#include <filesystem>

#include "bt_core/testing/leaf_harness.h"
#include "bt_nodes/interaction/interaction_leaves.h"
#include "robot_app/common/child_process.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::adapters {
namespace {

// The newest text on a topic.
class Listener {
 public:
  Listener(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe<std_msgs::String>(
            topic, 10, [this](const std_msgs::String::ConstPtr& message) {
              const std::lock_guard<std::mutex> lock(mutex_);
              text_ = message->data;
            })) {}
  std::string text() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return text_;
  }
  bool connected() const { return subscriber_.getNumPublishers() > 0; }

 private:
  std::mutex mutex_;
  std::string text_;
  ros::Subscriber subscriber_;
};

TEST(RosInteraction, ShowsATextAsLongAsItWouldTakeWhereNobodySpeaks) {
  ros::NodeHandle node;
  RosInteraction interaction(node);
  Listener speech(node, "/speech");
  ASSERT_TRUE(Eventually([&] { return speech.connected(); }));
  LeafHarness harness = LeafHarness::For<leaves::Say>(std::ref<leaves::Interaction>(interaction));
  harness.Set("text", std::string("hello"));
  EXPECT_EQ(harness.Tick(), Status::kRunning);
  EXPECT_TRUE(Eventually([&] { return speech.text() == "hello"; }));
  EXPECT_TRUE(Eventually([&] { return harness.Tick() == Status::kSuccess; }));
}

TEST(RosInteraction, SpeaksWithTheMouthAndSucceedsWhenItHasBeenPlayed) {
  ros::NodeHandle node;
  TemporaryFolder folder;
  const ChildProcess mouth(
      {BinaryFolder() + "/bin/coppice-speech", "_output:=folder:" + folder.Path("said")},
      folder.Path("log"));
  RosInteraction interaction(node);
  ASSERT_TRUE(Eventually([&] { return interaction.has_mouth(); }));
  LeafHarness harness = LeafHarness::For<leaves::Say>(std::ref<leaves::Interaction>(interaction));
  harness.Set("text", std::string("hello"));
  EXPECT_TRUE(Eventually([&] { return harness.Tick() == Status::kSuccess; }));
  EXPECT_TRUE(std::filesystem::exists(folder.Path("said/0001.wav")));
}

}  // namespace
}  // namespace coppice::robot::adapters
