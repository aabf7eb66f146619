// Attacks on the supervisor page, by the network that it is on: the real program, real sockets.
#include <coppice_msgs/AskForHelp.h>
#include <coppice_msgs/HelpRequests.h>
#include <geometry_msgs/Twist.h>
#include <gmock/gmock.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "robot_app/common/child_process.h"
#include "robot_app/common/service_call.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/robot_app/assistance/page_caller.h"
#include "tests/robot_app/eventually.h"
#include "tests/robot_app/latest.h"
#include "tests/robot_app/ros_environment.h"
#include "tests/robot_app/text_of.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

using assistance::PageCaller;
using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kToken = "an operator's token";
constexpr const char* kViewerToken = "a viewer's token, long";
constexpr float kNothingMet = std::numeric_limits<float>::infinity();
constexpr int kMostSteps = 600;  // of a tenth of a second

class PageAttack : public testing::Test {
 protected:
  PageAttack() {
    std::ofstream(folder_ + "supervisors.yaml")
        << "channels: [{name: here, kind: console}]\n"
           "supervisors: [{name: Ada, reach: [{channel: here}]}]\n"
           "page: {port: "
        << port_
        << ", operator_token: \"${PAGE_ATTACK_TOKEN}\", viewer_token: \"${PAGE_ATTACK_VIEWER}\"}\n";
  }

  ChildProcess Start(const std::string& token) const {
    return ChildProcess({BinaryFolder() + "/bin/coppice-assistance", "--config",
                         folder_ + "supervisors.yaml", "--live-port", "0"},
                        Log(),
                        {{"PAGE_ATTACK_TOKEN", token}, {"PAGE_ATTACK_VIEWER", kViewerToken}});
  }
  std::string Log() const { return folder_ + "assistance.log"; }

  void Open() {
    program_ = Start(kToken);
    ASSERT_TRUE(Eventually([&] {
      try {
        return !PageCaller(port_).Get("/").empty();
      } catch (const std::runtime_error&) {
        return false;
      }
    })) << TextOf(Log());
  }

  std::string LogIn(const std::string& token) const {
    PageCaller caller(port_);
    return caller.Post("/login", R"({"token": ")" + token + "\"}", caller.own_origin());
  }

  const std::uint16_t port_ = processes::FreePort();
  const std::string folder_ = testing::TempDir() + "page_attack_" + std::to_string(getpid()) + "_";
  ChildProcess program_;
};

TEST_F(PageAttack, PeopleAreAskedThoughTheDiskIsSlow) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer wants to be loaded first";
#endif
  const std::string ready = folder_ + "ready", state = folder_ + "state.json";
  program_ = ChildProcess({BinaryFolder() + "/bin/coppice-assistance", "--config",
                           folder_ + "supervisors.yaml", "--live-port", "0", "--state", state},
                          Log(),
                          {{"PAGE_ATTACK_TOKEN", kToken},
                           {"PAGE_ATTACK_VIEWER", kViewerToken},
                           {"LD_PRELOAD", BinaryFolder() + "/tests/lib/libtest_slow_disk.so"},
                           {"COPPICE_TEST_DISK_READY", ready}});
  ros::NodeHandle node;
  const Latest<coppice_msgs::HelpRequests> requests(node, "/assistance/requests");
  for (const std::size_t count : {1, 2}) {
    coppice_msgs::AskForHelp ask;
    ask.request.subject = "fault " + std::to_string(count);
    ASSERT_TRUE(Eventually([&] { return CallService("/assistance/ask", ask); })) << TextOf(Log());
    EXPECT_TRUE(
        Eventually([&] { return requests.get() && requests.get()->requests.size() == count; }));
  }
  std::ofstream(ready) << "now\n";
  EXPECT_EQ(program_.Stop(std::chrono::seconds(10)), 0);
  EXPECT_THAT(TextOf(state), HasSubstr("fault 2"));
}

// Somebody at the stick of a robot whose laser is in the hands of the test.
class PageAttackOnTheWheel : public PageAttack {
 protected:
  void SetUp() override {
    Open();
    geometry_msgs::TransformStamped mount;
    mount.header.frame_id = "base_link";
    mount.child_frame_id = "laser";
    mount.transform.rotation.w = 1;
    fixed_.sendTransform(mount);
    cookie_ = assistance::CookieOf(LogIn(kToken));
    driver_ = std::make_unique<PageCaller>(port_);
    ASSERT_THAT(driver_->Upgrade(cookie_, driver_->own_origin()), StartsWith("HTTP/1.1 101"));
    driver_->SendText(R"({"do": "take", "over": true})");
    ASSERT_TRUE(DriveUntil([&] { return Speed() > 0.3; })) << "it does not drive at all";
  }

  double Speed() const {
    const auto command = command_.get();
    return command ? command->linear.x : NAN;
  }

  // Asks for full speed at each beat of the robot, until something has come true.
  bool DriveUntil(const std::function<bool()>& predicate, std::uint64_t old_beat = 0) {
    for (int i = 0; i < kMostSteps && !predicate(); ++i) {
      PublishScan();
      NextBeat();
      driver_->SendText(R"({"do": "drive", "linear": 0.4, "angular": 0, "beat": )" +
                        std::to_string(old_beat != 0 ? old_beat : beat_) + "}");
    }
    return predicate();
  }

  void PublishScan() {
    sensor_msgs::LaserScan scan;
    scan.header.frame_id = "laser";
    scan.header.stamp = ros::Time::now();
    scan.angle_min = -2;
    scan.angle_increment = 0.1F;
    scan.range_min = 0.05F;
    scan.range_max = 20;
    scan.ranges = ranges_;
    scan_.publish(scan);
  }

  void NextBeat() {
    for (std::string text = driver_->Read(); !text.empty(); text = driver_->Read()) {
      const json message = json::parse(text, nullptr, false);
      if (!message.is_object() || message.value("type", "") != "beat") continue;
      beat_ = message.at("beat");
      return;
    }
    FAIL() << "the page has hung up";
  }

  ros::NodeHandle node_;
  tf2_ros::StaticTransformBroadcaster fixed_;
  ros::Publisher scan_ = node_.advertise<sensor_msgs::LaserScan>("/scan", 1);
  const Latest<geometry_msgs::Twist> command_{node_, "/cmd_vel/supervisor"};
  std::vector<float> ranges_ = std::vector<float>(40, kNothingMet);
  std::string cookie_;
  std::unique_ptr<PageCaller> driver_;
  std::uint64_t beat_ = 0;
};

TEST_F(PageAttackOnTheWheel, ALaserThatTellsNothingIsNoFreeWay) {
  ranges_.assign(40, NAN);
  EXPECT_TRUE(DriveUntil([&] { return Speed() == 0; }));
}

TEST_F(PageAttackOnTheWheel, ALaserWithoutBeamsIsNoFreeWay) {
  ranges_.clear();
  EXPECT_TRUE(DriveUntil([&] { return Speed() == 0; }));
}

TEST_F(PageAttackOnTheWheel, WhatTheNetworkHoldsBackDoesNotMoveTheRobotLater) {
  const std::uint64_t old = beat_;
  EXPECT_TRUE(DriveUntil([&] { return Speed() == 0; }, old));
}

TEST_F(PageAttackOnTheWheel, APageThatIsClosedWhileItDrivesLeavesAZero) {
  driver_.reset();
  EXPECT_TRUE(Eventually([&] { return Speed() == 0; }));
}

TEST_F(PageAttackOnTheWheel, ScansAreSentToThePageOnlyWhileSomebodyLooks) {
  EXPECT_TRUE(Eventually([&] { return scan_.getNumSubscribers() == 1; }));
  driver_.reset();
  EXPECT_TRUE(Eventually([&] { return scan_.getNumSubscribers() == 0; }));
}

TEST_F(PageAttackOnTheWheel, AnOpenPageHearsNothingAfterTheLogOut) {
  PageCaller leaver(port_);
  leaver.Post("/logout", "", leaver.own_origin(), cookie_);
  int heard = 0;
  while (heard < kMostSteps && !driver_->Read().empty()) ++heard;
  EXPECT_LT(heard, kMostSteps);
}

TEST_F(PageAttack, WrongTokensKeepNobodyOut) {
  Open();
  for (int i = 0; i < 25; ++i) EXPECT_THAT(LogIn("guess"), StartsWith("HTTP/1.1 403"));
  EXPECT_THAT(LogIn(kToken), StartsWith("HTTP/1.1 204"));
}

TEST_F(PageAttack, SilentConnectionsKeepNobodyOut) {
  Open();
  std::vector<std::unique_ptr<PageCaller>> silent;
  for (int i = 0; i < 300; ++i) silent.push_back(std::make_unique<PageCaller>(port_));
  EXPECT_THAT(LogIn(kToken), StartsWith("HTTP/1.1 204"));
}

// With the viewer's token, once as one session and once as many.
TEST_F(PageAttack, WhoMayOnlyWatchKeepsNoOperatorOut) {
  Open();
  std::vector<std::unique_ptr<PageCaller>> viewers;
  std::string cookie;
  for (int i = 0; i < 300; ++i) {
    if (i < 2 || i >= 70) cookie = assistance::CookieOf(LogIn(kViewerToken));
    viewers.push_back(std::make_unique<PageCaller>(port_));
    viewers.back()->Upgrade(cookie, viewers.back()->own_origin());
  }
  const std::string mine = assistance::CookieOf(LogIn(kToken));
  PageCaller page(port_);
  EXPECT_THAT(page.Upgrade(mine, page.own_origin()), StartsWith("HTTP/1.1 101"));
}

TEST_F(PageAttack, ATokenThatCanBeGuessedIsNone) {
  ChildProcess program = Start("1234");
  ASSERT_TRUE(Eventually([&] { return !program.IsRunning(); }));
  EXPECT_EQ(program.exit_status(), 2);
  EXPECT_THAT(TextOf(Log()), HasSubstr("at least 16 are needed"));
}

}  // namespace
}  // namespace coppice::robot
