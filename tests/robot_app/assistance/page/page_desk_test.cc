#include "robot_app/assistance/page/page_desk.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

namespace coppice::robot::assistance {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// Remembers what is done to it.
class Robot : public PageRobot {
 public:
  void SetPose(const Pose2D& pose) override { poses.push_back(pose); }
  void Restart(const std::string& name,
               std::function<void(bool ok, const std::string& text)> done) override {
    restarts.push_back(name);
    done(true, name + " is restarted");
  }
  std::vector<Pose2D> poses;
  std::vector<std::string> restarts;
};

struct Sent {
  std::uint64_t client;
  std::string key;
  std::string text;
};

class Page : public testing::Test {
 protected:
  static AssistanceConfig Config() {
    AssistanceConfig config;
    config.robot = "Sobi";
    config.supervisors = {{"Ada", {{"c", ""}}}, {"Ben", {{"c", ""}}}};
    config.page.cameras = {{"front", "/front"}, {"rear", "/rear"}};
    return config;
  }

  void Join(std::uint64_t client, const std::string& name, PageRole role = PageRole::kOperator,
            std::uint32_t request = 0) {
    desk_.OnEvent({PageEvent::Kind::kJoined, client, {role, name, request, Time{}}, ""}, now_);
    passes_[client] = {role, name, request, Time{}};
  }
  std::string Say(std::uint64_t client, const std::string& text) {
    return desk_.OnEvent({PageEvent::Kind::kText, client, passes_[client], text}, now_);
  }
  void Leave(std::uint64_t client) {
    desk_.OnEvent({PageEvent::Kind::kLeft, client, passes_[client], ""}, now_);
  }
  // The last one that a client got.
  std::string Last(std::uint64_t client, const std::string& key) const {
    for (auto it = sent_.rbegin(); it != sent_.rend(); ++it) {
      if (it->client == client && it->key == key) return it->text;
    }
    return "";
  }

  Time now_{std::chrono::seconds(1000)};
  const AssistanceConfig config_ = Config();
  HelpDesk help_{config_.supervisors, [](const std::string&) { return HelpRules(); }};
  teleoperation::Teleoperation wheel_{teleoperation::TeleoperationSettings{}};
  Robot robot_;
  std::vector<Sent> sent_;
  std::map<std::uint64_t, PagePass> passes_;
  PageDesk desk_{
      config_, help_, wheel_, robot_,
      [this](std::uint64_t client, const std::string& key, const PageDesk::Message& message, bool) {
        sent_.push_back({client, key, *message});
      }};
};

TEST_F(Page, WhoJoinsHearsWhoTheyAreAndWhatIsShown) {
  desk_.Show("health", "{\"type\":\"health\"}");
  Join(1, "Ada");
  const json hello = json::parse(Last(1, "hello"));
  EXPECT_EQ(hello.at("name"), "Ada");
  EXPECT_EQ(hello.at("operator"), true);
  EXPECT_EQ(hello.at("cameras"), json({"front", "rear"}));
  EXPECT_EQ(Last(1, "health"), "{\"type\":\"health\"}");
}

TEST_F(Page, WhoComesByALinkTakesTheRequest) {
  const std::uint32_t id = help_.Ask("navigation", "Blocked.", now_).value();
  Join(1, "Ada", PageRole::kOperator, id);
  EXPECT_EQ(help_.Find(id)->taken_by, "Ada");
}

TEST_F(Page, AnAnswerClosesTheRequestAndIsThanked) {
  const std::uint32_t id = help_.Ask("navigation", "Blocked.", now_).value();
  Join(1, "Ada");
  Say(1, R"({"do": "answer", "fixed": true, "request": )" + std::to_string(id) + "}");
  EXPECT_EQ(help_.Find(id)->state, HelpState::kFixed);
  EXPECT_EQ(help_.Find(id)->answered_by, "Ada");
  EXPECT_THAT(Last(1, "told"), HasSubstr("Thank you"));
  desk_.Step(now_);
  EXPECT_THAT(Last(1, "requests"), HasSubstr("\"state\":\"fixed\""));
}

TEST_F(Page, AViewerMayOnlyWatch) {
  Join(1, "viewer", PageRole::kViewer);
  for (const char* const text :
       {R"({"do": "take", "over": true})",
        R"({"do": "drive", "linear": 1, "angular": 0, "beat": 1000000})",
        R"({"do": "set_pose", "x": 1, "y": 2, "yaw": 0})", R"({"do": "restart", "name": "a"})",
        R"({"do": "answer", "request": 1, "fixed": true})"}) {
    Say(1, text);
    EXPECT_THAT(Last(1, "told"), HasSubstr("watch only"));
  }
  EXPECT_EQ(wheel_.driver(), 0u);
  EXPECT_THAT(robot_.poses, IsEmpty());
  EXPECT_THAT(robot_.restarts, IsEmpty());
  Say(1, R"({"do": "cameras", "names": ["front"]})");
  EXPECT_TRUE(desk_.is_watched(0));
}

TEST_F(Page, OnePersonDrivesAndAnotherHearsWhoItIs) {
  wheel_.SetObstacles({}, now_);
  Join(1, "Ada");
  Join(2, "Ben");
  Say(1, R"({"do": "take", "over": false})");
  Say(1, R"({"do": "drive", "linear": 0.2, "angular": 0, "beat": 1000000})");
  Say(2, R"({"do": "take", "over": false})");
  EXPECT_THAT(Last(2, "wheel_taken"), HasSubstr("Ada"));
  Say(2, R"({"do": "drive", "linear": -0.2, "angular": 0, "beat": 1000000})");
  EXPECT_EQ(wheel_.Command(now_)->linear, 0.2);
  Say(2, R"({"do": "take", "over": true})");
  EXPECT_EQ(wheel_.driver_name(), "Ben");
}

TEST_F(Page, ACommandBearsTheBeatThatThePageHasGotAndCountsUntilThatIsOld) {
  wheel_.SetObstacles({}, now_ + std::chrono::milliseconds(600));
  desk_.Step(now_);
  Join(1, "Ada");
  const std::string beat = json::parse(Last(1, "beat")).at("beat").dump();
  const std::string drive = R"({"do": "drive", "linear": 0.2, "angular": 0, "beat": )" + beat + "}";
  Say(1, R"({"do": "take", "over": false})");
  now_ += std::chrono::milliseconds(500);
  Say(1, drive);
  EXPECT_EQ(wheel_.Command(now_)->linear, 0.2);
  now_ += std::chrono::milliseconds(1);
  Say(1, drive);
  EXPECT_EQ(wheel_.Command(now_)->linear, 0);
}

TEST_F(Page, WhoClosesThePageLeavesTheWheel) {
  Join(1, "Ada");
  Say(1, R"({"do": "take", "over": false})");
  Leave(1);
  EXPECT_EQ(wheel_.driver(), 0u);
  EXPECT_FALSE(desk_.is_watched());
}

TEST_F(Page, ThePositionIsSetAndProgramsAreRestarted) {
  Join(1, "Ada");
  Say(1, R"({"do": "set_pose", "x": 1, "y": 2, "yaw": 3})");
  ASSERT_EQ(robot_.poses.size(), 1u);
  EXPECT_EQ(robot_.poses[0].y, 2);
  Say(1, R"({"do": "restart", "name": "navigation"})");
  EXPECT_THAT(robot_.restarts, Contains("navigation"));
  EXPECT_THAT(Last(1, "told"), HasSubstr("is restarted"));
}

TEST_F(Page, PicturesGoToThoseWhoWatchThem) {
  Join(1, "Ada");
  Join(2, "Ben");
  Say(1, R"({"do": "cameras", "names": ["rear", "nowhere"]})");
  EXPECT_FALSE(desk_.is_watched(0));
  EXPECT_TRUE(desk_.is_watched(1));
  desk_.ShowPicture(1, "jpeg", 4);
  EXPECT_EQ(Last(1, "camera 1"), std::string("\x01\x01jpeg"));
  EXPECT_EQ(Last(2, "camera 1"), "");
}

TEST_F(Page, APictureThatIsNoJpegOfACameraIsNotShown) {
  Join(1, "Ada");
  Say(1, R"({"do": "cameras", "names": ["rear"]})");
  const std::string raw(5 << 20, 'x');  // a driver may send what it measured as it is
  desk_.ShowPicture(1, raw.data(), raw.size());
  EXPECT_EQ(Last(1, "camera 1"), "");
}

TEST_F(Page, NonsenseIsAnsweredAndNothingElseHappens) {
  Join(1, "Ada");
  Say(1, "nonsense");
  EXPECT_THAT(Last(1, "told"), HasSubstr("does not understand"));
  EXPECT_EQ(Say(99, R"({"do": "take", "over": true})"), "");  // of one who has left
  EXPECT_EQ(wheel_.driver(), 0u);
}

}  // namespace
}  // namespace coppice::robot::assistance
