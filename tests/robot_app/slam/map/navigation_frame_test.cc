#include "robot_app/slam/map/navigation_frame.h"

#include <gtest/gtest.h>

#include "robot_app/slam/graph/floor_pose.h"

namespace coppice::robot::slam {
namespace {

constexpr Pose2D kFrame{3, -2, 0.7};  // of the map, in that of the navigation's

class NavigationFrameTest : public testing::Test {
 protected:
  void Session(int key_frames) {
    graph_.BeginSession();
    for (int i = 0; i < key_frames; ++i) {
      graph_.AddPose(ToPose3({0.5, 0, 0.1}), Matrix6::Identity());
      key_frames_.push_back(std::make_shared<KeyFrame>());
    }
  }
  // The localization says where it was.
  void Know(std::size_t key_frame, const Pose2D& frame) {
    const Pose2D mapped = ToPose2D(graph_.poses()[key_frame]);
    std::const_pointer_cast<KeyFrame>(key_frames_[key_frame])->place = Compose(frame, mapped);
  }
  Pose2D FrameOf(std::size_t session) const {
    const auto frames = OnNavigationMap(graph_, key_frames_);
    EXPECT_TRUE(frames[session].has_value());
    return ToPose2D(frames[session].value_or(Pose3::Identity()));
  }

  SessionGraph graph_;
  std::vector<std::shared_ptr<const KeyFrame>> key_frames_;
};

TEST_F(NavigationFrameTest, NobodyKnowsItBeforeTheLocalizationWasSure) {
  EXPECT_TRUE(OnNavigationMap(graph_, key_frames_).empty());
  Session(3);
  EXPECT_FALSE(OnNavigationMap(graph_, key_frames_)[0].has_value());
}

TEST_F(NavigationFrameTest, OneKeyFrameIsEnough) {
  Session(3);
  Know(2, kFrame);
  EXPECT_LT(Distance(FrameOf(0), kFrame), 1e-9);
  EXPECT_NEAR(FrameOf(0).yaw, kFrame.yaw, 1e-9);
}

TEST_F(NavigationFrameTest, AFewThatAreWrongDoNotCount) {
  Session(50);
  for (std::size_t i = 0; i < 50; ++i) Know(i, kFrame);
  for (std::size_t i = 0; i < 50; i += 5) Know(i, {20, 5, -2});
  EXPECT_LT(Distance(FrameOf(0), kFrame), 1e-6);
  EXPECT_NEAR(FrameOf(0).yaw, kFrame.yaw, 1e-6);
}

TEST_F(NavigationFrameTest, EachMapLiesForItself) {
  Session(10);
  Session(10);
  Know(3, kFrame);
  Know(15, {-1, 4, 2});
  EXPECT_LT(Distance(FrameOf(0), kFrame), 1e-9);
  EXPECT_LT(Distance(FrameOf(1), {-1, 4, 2}), 1e-9);
}

TEST_F(NavigationFrameTest, AMapIsMovedThereAsAWhole) {
  Session(5);
  Know(0, kFrame);
  const SlamMap moved =
      MovedToNavigationMap({key_frames_, graph_.graph(), graph_.sessions(), {{}}});
  for (std::size_t i = 0; i < 5; ++i) {
    const Pose2D expected = Compose(kFrame, ToPose2D(graph_.poses()[i]));
    EXPECT_LT(Distance(ToPose2D(moved.graph.poses[i]), expected), 1e-9) << i;
  }
}

}  // namespace
}  // namespace coppice::robot::slam
