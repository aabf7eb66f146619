// coppice-tablet: the node /tablet, which serves the page of the tablet in the robot's chest.
#include <coppice_msgs/Answer.h>
#include <coppice_msgs/Expression.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/base/command_line.h"
#include "robot_app/common/find_master.h"
#include "robot_app/common/ros_support.h"
#include "robot_app/common/service_call.h"
#include "robot_app/common/service_caller.h"
#include "robot_app/common/shipped.h"
#include "robot_app/common/web/call_server.h"
#include "robot_app/knowledge/import/fill_database.h"
#include "robot_app/tablet/tablet_desk.h"

namespace coppice::robot::tablet {
namespace {

constexpr double kPosePeriod = 0.25;        // wall time [s]
constexpr int kMostCells = 4'000'000;       // of a map that a page can draw
constexpr std::size_t kLongestText = 2000;  // bytes
constexpr std::size_t kMostChoices = 3, kMostSlots = 8;
constexpr double kOpen = 10;  // after its last question a page counts as open [s]

const Command& TabletCommand() {
  static const Command command{
      "coppice-tablet",
      "serve the page of the robot's tablet",
      {},
      "Serves the page of the tablet in the robot's chest, as the ROS node /tablet: what is where,\n"
      "with the way from here, people, menus, departures, and to be guided.\n"
      "  subscribes  /map /tf /face/image /speech/answer /visitors/outcome\n"
      "  publishes   /speech/answer /tablet/touched /expression\n"
      "  calls       /speech/listen (std_srvs/SetBool), again and again while somebody holds the\n"
      "              button to talk",
      {CommandOption::Text("--knowledge", "DB", "what coppice-knowledge has imported").Needed(),
       CommandOption::Text("--site", "FOLDER", "a folder, or sample: fills DB if it is empty"),
       CommandOption::Text("--places", "FILE", "the places and the ways between them").Needed(),
       CommandOption::Text("--language", "CODE", "en or de, while nobody has chosen one; else en"),
       CommandOption::Text("--address", "ADDRESS", "to listen on; else 127.0.0.1"),
       CommandOption::Whole("--port", "N", 0, 65535, "of the page, 0 = a free one; else 8091"),
       CommandOption::Text("--name", "NAME",
                           "by which browsers ask for it, if a name server knows it"),
       CommandOption::Text("--page", "FOLDER", "of its files; else the one that was built")}};
  return command;
}

class RosLinks : public TabletLinks {
 public:
  explicit RosLinks(ros::NodeHandle& node)
      : answers_(node.advertise<coppice_msgs::Answer>("/speech/answer", 10)),
        touched_(node.advertise<std_msgs::Empty>("/tablet/touched", 10)),
        expression_(node.advertise<coppice_msgs::Expression>("/expression", 10)) {}

  void Touched() override { touched_.publish(std_msgs::Empty()); }

  void Talk(bool on) override {
    coppice_msgs::Expression wish;
    wish.owner = "tablet";
    wish.expression = on ? "LISTENING" : "NEUTRAL";
    expression_.publish(wish);
    calls_.RunFinished();
    const bool is_changed = std::exchange(is_talking_, on) != on;
    if (!is_changed && (!on || is_calling_)) return;
    std_srvs::SetBool listen;
    listen.request.data = on;
    is_calling_ = true;
    calls_.Add([this, listen]() mutable -> ServiceCaller::Finish {
      CallService("/speech/listen", listen);  // where nobody listens, the face does all the same
      return [this] { is_calling_ = false; };
    });
  }

  void Answered(const knowledge::Answer& answer, const std::string& language) override {
    coppice_msgs::Answer message;
    message.header.stamp = ros::Time::now();
    message.heard.header.stamp = message.header.stamp;
    message.heard.source = coppice_msgs::Heard::TABLET;
    message.heard.language = message.language = language;
    message.heard.confidence = 1;
    message.mood = static_cast<std::uint8_t>(answer.mood);
    message.text = answer.text;
    message.place = answer.place;
    message.guides = answer.guides;
    message.intent = answer.guides ? "guide" : "";
    answers_.publish(message);
  }

  void StopGuiding() override {
    coppice_msgs::Answer message;
    message.header.stamp = ros::Time::now();
    message.heard.source = coppice_msgs::Heard::TABLET;
    message.intent = "cancel";
    answers_.publish(message);
  }

 private:
  ros::Publisher answers_, touched_, expression_;
  bool is_talking_ = false, is_calling_ = false;
  ServiceCaller calls_;
};

// Those that mean something here.
std::vector<knowledge::Choice> ChoicesOf(const coppice_msgs::Answer& answer) {
  std::vector<knowledge::Choice> choices;
  for (const coppice_msgs::Choice& told : answer.choices) {
    const auto intent = knowledge::IntentOf(told.intent);
    if (!intent || choices.size() == kMostChoices) continue;
    knowledge::Choice& choice = choices.emplace_back();
    choice.label = told.label.substr(0, kLongestText);
    choice.request.intent = *intent;
    for (const std::string& slot : told.slots) {
      const std::size_t equals = std::min(slot.find('='), slot.size());
      const auto kind = knowledge::KindOf(slot.substr(0, equals));
      if (!kind || choice.request.slots.size() == kMostSlots) continue;
      choice.request.slots.push_back({*kind, slot.substr(std::min(equals + 1, slot.size()))});
    }
  }
  return choices;
}

class TabletNode {
 public:
  TabletNode(TabletDesk& desk, ros::NodeHandle& node) : desk_(desk) {
    subscribers_ = {node.subscribe("/map", 1, &TabletNode::OnMap, this),
                    node.subscribe("/face/image", 1, &TabletNode::OnFace, this),
                    node.subscribe("/speech/answer", 10, &TabletNode::OnAnswer, this),
                    node.subscribe("/visitors/outcome", 10, &TabletNode::OnOutcome, this)};
    timer_ = node.createWallTimer(ros::WallDuration(kPosePeriod),
                                  [this](const ros::WallTimerEvent&) { LookWhereItIs(); });
  }

 private:
  void OnMap(const nav_msgs::OccupancyGrid& message) {
    Expected<OccupancyGrid> grid = ToGrid(message);
    if (grid && grid->frame.size() <= kMostCells) desk_.SetGrid(*std::move(grid));
  }
  void OnFace(const sensor_msgs::Image& image) {
    const bool is_face = image.width == 64 && image.height == 32 && image.encoding == "rgb8" &&
                         image.data.size() == std::size_t{64} * 32 * 3;
    if (!is_face) return;
    desk_.ChangeView([&](TabletView& view) {
      view.face = image.data;
      ++view.face_number;
    });
  }
  // What is answered to somebody who spoke; to those at the tablet its own page has told it.
  void OnAnswer(const coppice_msgs::Answer& answer) {
    if (answer.heard.source == coppice_msgs::Heard::TABLET) return;
    desk_.ChangeView([&](TabletView& view) {
      view.said = {static_cast<knowledge::AnswerMood>(std::min<int>(answer.mood, 2)),
                   answer.text.substr(0, kLongestText), answer.place.substr(0, kLongestText),
                   answer.guides != 0};
      view.said.choices = ChoicesOf(answer);
      ++view.said_number;
      if (answer.guides) view.outcome.clear();
    });
  }
  void OnOutcome(const std_msgs::String& outcome) {
    desk_.ChangeView(
        [&](TabletView& view) { view.outcome = outcome.data.substr(0, kLongestText); });
  }
  // Only while somebody looks at the page: transforms come often.
  void LookWhereItIs() {
    const ros::WallTime now = ros::WallTime::now();
    desk_.EndTalkUnlessHeld();
    if (desk_.TakeWasAsked()) asked_ = now;
    if (now - asked_ > ros::WallDuration(kOpen)) {
      pose_.reset();
    } else if (!pose_) {
      pose_.emplace(Frames());
    }
    const auto newest = pose_ ? pose_->Newest() : std::nullopt;
    desk_.ChangeView([&](TabletView& view) {
      view.pose = newest ? std::optional<Pose2D>(newest->pose) : std::nullopt;
    });
  }

  TabletDesk& desk_;
  std::optional<RobotPose> pose_;  // while the page is open
  ros::WallTime asked_;            // by the page
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
};

// Throws if a file cannot be read; what is wrong with it was told.
std::unique_ptr<TabletDesk> OpenDesk(const Options& options, TabletLinks& links) {
  const std::string file = options.Get("--knowledge");
  auto opened = knowledge::OpenFilled(file, options.Get("--site"));
  if (!opened) throw std::runtime_error(opened.problem());
  if (opened->is_copy()) ROS_WARN("%s cannot be written; it is read as it is", file.c_str());
  Diagnostics diagnostics;
  auto dialogue =
      knowledge::Dialogue::Make(*std::move(opened), Shipped(COPPICE_LANGUAGE_FOLDER), diagnostics);
  auto map = TopologicalMap::Load(options.Get("--places"), diagnostics);
  std::cerr << diagnostics.ToString();
  if (!dialogue || !map) throw std::runtime_error("without them the tablet knows nothing");
  const auto language = knowledge::LanguageOf(options.Get("--language", "en"));
  if (!language) throw std::runtime_error("--language must be en or de");
  dialogue->set_language(*language);
  return std::make_unique<TabletDesk>(std::move(dialogue), *std::move(map), links,
                                      [] { return std::chrono::system_clock::now(); });
}

int Serve(const Options& options) {
  ros::NodeHandle node;
  RosLinks links(node);
  const std::unique_ptr<TabletDesk> desk = OpenDesk(options, links);
  const CallServer server(
      {options.Get("--address", "127.0.0.1"),
       static_cast<std::uint16_t>(options.Whole("--port", 8091)),
       options.Get("--page", Shipped(COPPICE_TABLET_FOLDER)), options.Get("--name")},
      [&](const std::string& call) { return desk->Reply(call); });
  const TabletNode robot(*desk, node);
  ROS_INFO("the tablet's page is served at http://%s:%d",
           options.Get("--address", "127.0.0.1").c_str(), server.port());
  ros::spin();
  return 0;
}

int Main(int argc, char** argv) {
  const Options options = ParseOptions(TabletCommand(), {argv + 1, argv + argc});
  if (options.exit) return *options.exit;
  int no_arguments = 0;
  ros::init(no_arguments, nullptr, "tablet");
  if (!FindMaster("coppice-tablet")) return 2;
  try {
    return Serve(options);
  } catch (const std::exception& error) {
    std::cerr << "coppice-tablet: " << error.what() << "\n";
    return 2;
  }
}

}  // namespace
}  // namespace coppice::robot::tablet

int main(int argc, char** argv) { return coppice::robot::tablet::Main(argc, argv); }
