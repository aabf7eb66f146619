// coppice-robot: runs the application tree and the monitor tree on a robot.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/String.h>
#include <visualization_msgs/MarkerArray.h>

#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/base/command_line.h"
#include "bt_nodes/register_nodes.h"
#include "robot_app/app/face_pictures.h"
#include "robot_app/app/note_limit.h"
#include "robot_app/app/robot_figures.h"
#include "robot_app/app/tree_link.h"
#include "robot_app/app/tree_runner.h"
#include "robot_app/common/configuration/site_phrases.h"
#include "robot_app/common/find_master.h"
#include "robot_app/common/places/site_places.h"
#include "robot_app/common/places/station_place.h"
#include "robot_app/common/ros_clock.h"
#include "robot_app/common/shipped.h"
#include "robot_app/ros/duty_feed.h"
#include "robot_app/ros/feeds.h"
#include "robot_app/ros/people_feed.h"
#include "robot_app/ros/pose_feed.h"
#include "robot_app/ros/ros_face.h"
#include "robot_app/ros/ros_interaction.h"
#include "robot_app/ros/ros_navigator.h"
#include "robot_app/ros/ros_process_manager.h"
#include "robot_app/ros/ros_recovery_log.h"
#include "robot_app/ros/ros_supervisors.h"
#include "robot_app/ros/visitor_feed.h"
#include "robot_app/ros/way_markers.h"

namespace coppice::robot {
namespace {

constexpr double kHeartbeatPeriod = 1;  // s

const Command& RobotCommand() {
  static const Command command{
      "coppice-robot",
      "run the trees of a robot",
      {},
      R"(Runs both trees until the application ends, then goes on monitoring until it is
stopped. The application may be any tree, for example trees/behavior/leave_station.xml.)",
      {CommandOption::Text("--application", "FILE", "the application tree").Needed(),
       CommandOption::Text("--monitor", "FILE", "the monitor tree").Needed(),
       CommandOption::Text("--places", "FILE", "the places that the trees speak of").Needed(),
       CommandOption::Text("--phrases", "FILE", "what they say to visitors; else the shipped one"),
       CommandOption::Text("--learn", "FILE",
                           "keeps what it learns of the ways between them there"),
       CommandOption::Text("--tree", "ID",
                           "of the application one that is not the main tree of its file"),
       CommandOption::Text("--record", "FOLDER", "records both trees there"),
       CommandOption::Whole("--live-port", "N", 0, 65533,
                            "live socket of the application, the monitor's is at N + 2; else 1667; "
                            "0 = none"),
       CommandOption::Whole("--metrics-port", "N", 0, 65535,
                            "serves /metrics for Prometheus there; else 0 = none"),
       CommandOption::Text("--metrics-address", "ADDRESS",
                           "of that; else 127.0.0.1. Any other needs COPPICE_METRICS_TOKEN"),
       CommandOption::Text("--hours", "HOURS",
                           "when it works, as \"Mo-Fr 09:00-17:00\", else it rests on its station; "
                           "else at any time"),
       CommandOption::Whole("--rounds", "N", -1, 1e9, "patrol rounds; else -1 = for ever"),
       CommandOption::Whole("--stops", "N", 0, 1e9, "places per round; else 4"),
       CommandOption::Whole("--seed", "N", 0, UINT32_MAX, "chooses the places; else 1")}};
  return command;
}

adapters::FeedKeys KeysOf(Executor& executor) {
  return {executor.Writer<double>("battery_level"),
          executor.Writer<bool>("charging"),
          executor.Writer<bool>("docked"),
          executor.Writer<leaves::Health>("monitoring"),
          executor.Writer<std::string>("configuration"),
          executor.Writer<std::string>("site"),
          executor.Writer<bool>("manual"),
          executor.Writer<std::string>("processes"),
          executor.Writer<leaves::BatteryReading>("battery")};
}

adapters::PoseKeys PoseKeysOf(Executor& executor) {
  return {executor.Writer<leaves::Pose2D>("pose"), executor.Writer<double>("distance_to_station")};
}

// Without a port there is no page.
std::optional<metrics::MetricsPageOptions> PageOf(const Options& options) {
  metrics::MetricsPageOptions page;
  page.port = static_cast<std::uint16_t>(options.Whole("--metrics-port", 0));
  page.address = options.Get("--metrics-address", page.address);
  if (const char* token = std::getenv("COPPICE_METRICS_TOKEN")) page.token = token;
  return page.port == 0 ? std::nullopt : std::optional(page);
}

leaves::Pose2D HomeOf(const TopologicalMap& map) {
  const int home = HomeOn(map);
  if (home < 0) throw std::runtime_error("the site has no station and no meeting point");
  const Pose2D pose = *map.places()[static_cast<std::size_t>(home)].pose;
  return {pose.x, pose.y, pose.yaw};
}

SitePhrases PhrasesOf(const Options& options) {
  Diagnostics diagnostics;
  SitePhrases phrases(options.Get("--phrases", Shipped(COPPICE_PHRASES)), diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors()) throw std::runtime_error("the robot knows not what to say");
  return phrases;
}

// All that a robot program needs, in the order of construction; torn down in reverse.
class Robot {
 public:
  Robot(ros::NodeHandle& node, const Options& options)
      : node_(node),
        is_recorded_(options.Has("--record")),
        navigator_(adapters::MakeRosNavigator(node)),
        places_(options.Get("--places"), static_cast<unsigned>(options.Whole("--seed", 1)), clock_,
                options.Get("--learn")),
        station_(adapters::MakeRosChargingStation(node)),
        interaction_(node),
        face_(node),
        visitors_(node, clock_),
        phrases_(PhrasesOf(options)),
        supervisors_(node),
        recoveries_(node, clock_),
        figures_(node, PageOf(options)),
        face_pictures_(node) {
    const int port = static_cast<int>(options.Whole("--live-port", 1667));
    application_ = MakeRunner(options, "application", port, false);
    monitor_ = MakeRunner(options, "monitor", port > 0 ? port + 2 : 0, true);
    SetIfUsed(options, "rounds", "-1");
    SetIfUsed(options, "stops", "4");
    link_.Connect(*application_, *monitor_);
    Executor& application = application_->executor();
    Executor& monitor = monitor_->executor();
    subscribers_ = adapters::SubscribeFeeds(node_, {KeysOf(application), KeysOf(monitor)}, clock_);
    pose_feed_.emplace(node_, HomeOf(places_.guide().map()),
                       std::vector{PoseKeysOf(application), PoseKeysOf(monitor)});
    people_feed_.emplace(node_,
                         std::vector{application.Writer<leaves::PeopleView>("people"),
                                     monitor.Writer<leaves::PeopleView>("people")},
                         clock_);
    FeedDuty(options.Get("--hours", ""));
    visitors_.Connect({application.Writer<leaves::Visitor>("visitor"),
                       monitor.Writer<leaves::Visitor>("visitor")});
    subscribers_.push_back(node_.subscribe<std_msgs::String>(
        "/coppice/note", 20, [this](const std_msgs::String::ConstPtr& note) { Note(note->data); }));
    status_ = node_.advertise<std_msgs::String>("/coppice/application", 1, true);
    ways_ = node_.advertise<visualization_msgs::MarkerArray>("/coppice/ways", 1, true);
    places_.ShowWays([this](const RouteGuide& guide) {
      ways_.publish(adapters::MarkersOf(guide.map(), guide.memory(), clock_.Now(), "map"));
    });
    heartbeat_ = node_.advertise<std_msgs::Empty>("/coppice/heartbeat", 1);
    diagnostics_ = node_.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
  }

  void Start() {
    Announce(Status::kRunning);
    application_->Start([this](Status result) { Announce(result); });
    monitor_->Start([](Status) {});
    // In wall time: what the trees wait for may be the clock of the simulation.
    heart_ = node_.createWallTimer(ros::WallDuration(kHeartbeatPeriod),
                                   [this](const ros::WallTimerEvent&) { Beat(); });
  }

  // The application first, so that the monitor does not take its end for a fault.
  void Stop() {
    application_->Stop();
    monitor_->Stop();
  }

 private:
  void Note(const std::string& text) {
    const auto note = note_limit_.Pass(text, ros::SteadyTime::now().toSec());
    if (!note) {
      ROS_WARN_THROTTLE(60, "more than %d notes a second on /coppice/note: some are not recorded",
                        NoteLimit::kMostPerSecond);
      return;
    }
    application_->Note("note", *note);
    monitor_->Note("note", *note);
  }

  std::unique_ptr<TreeRunner> MakeRunner(const Options& options, const std::string& name, int port,
                                         bool forever) {
    Diagnostics diagnostics;
    const std::string tree = name == "application" ? options.Get("--tree") : "";
    const auto registry = std::make_shared<Registry>();
    leaves::RegisterNodes(*registry,
                          {*navigator_, places_, places_, *station_, interaction_, face_, visitors_,
                           phrases_, processes_, supervisors_, link_, recoveries_});
    const auto program = CompileFile(options.Get("--" + name), registry, diagnostics, tree);
    std::cerr << diagnostics.ToString();
    if (!program) throw std::runtime_error("the " + name + " tree cannot run");
    TreeRunnerOptions runner;
    runner.name = name;
    runner.live_port = port;
    runner.pictures = face_pictures_.pictures();
    runner.listener = forever ? figures_.monitor() : figures_.application();
    if (const char* token = std::getenv("COPPICE_LIVE_TOKEN")) runner.live_token = token;
    runner.run.forever = forever;
    if (is_recorded_) runner.record_path = options.Get("--record") + "/" + name + ".coppice";
    return std::make_unique<TreeRunner>(program, clock_, runner);
  }

  // A tree of behaviours alone need not have the key; what is given on the command line must be of
  // use, though.
  void SetIfUsed(const Options& options, const std::string& key, const std::string& otherwise) {
    Executor& executor = application_->executor();
    const bool used = executor.program().layout.Find(kMainScope, key) != kNoSlot;
    if (!used && !options.Has("--" + key)) return;
    const Outcome set = SetKey(executor, key, options.Get("--" + key, otherwise));
    if (!set) throw std::runtime_error(set.problem());
  }

  // Without hours nobody tells the trees of any, and they are always on duty.
  void FeedDuty(const std::string& text) {
    if (text.empty()) return;
    const auto hours = knowledge::OpeningHours::Parse(text);
    if (!hours) throw std::runtime_error("--hours: " + hours.problem());
    duty_feed_.emplace(node_, *hours,
                       std::vector{application_->executor().Writer<double>("duty_left"),
                                   monitor_->executor().Writer<double>("duty_left")});
  }

  // The process supervisor restarts a program whose heart stands still.
  void Beat() {
    const bool application = application_->IsAlive(), monitor = monitor_->IsAlive();
    if (application && monitor) heartbeat_.publish(std_msgs::Empty());
    TellOfTroubles();
  }

  // Nothing that only watches a robot keeps it from running; but somebody has to hear of it.
  void TellOfTroubles() {
    diagnostic_msgs::DiagnosticArray message;
    for (const auto& [name, runner] :
         {std::pair("application", &*application_), std::pair("monitor", &*monitor_)}) {
      if (is_recorded_) message.status.push_back(Entry("record", name, runner->RecordTrouble()));
      if (!runner->LiveTrouble().empty()) {
        message.status.push_back(Entry("live view", name, runner->LiveTrouble()));
      }
    }
    if (!figures_.trouble().empty()) {
      message.status.push_back(Entry("metrics", "all trees", figures_.trouble()));
    }
    message.header.stamp = ros::Time::now();
    if (!message.status.empty()) diagnostics_.publish(message);
  }

  static diagnostic_msgs::DiagnosticStatus Entry(const std::string& what, const std::string& tree,
                                                 const std::string& trouble) {
    diagnostic_msgs::DiagnosticStatus status;
    status.name = "coppice_robot: " + what + " of " + tree;
    status.message = trouble;
    status.level = trouble.empty() ? status.OK : status.WARN;
    return status;
  }

  void Announce(Status status) {
    std_msgs::String message;
    message.data = ToString(status);
    status_.publish(message);
    ROS_INFO_STREAM("application: " << message.data);
  }

  ros::NodeHandle& node_;
  const bool is_recorded_;
  RosClock clock_;
  std::unique_ptr<leaves::Navigator> navigator_;
  SitePlaces places_;
  std::unique_ptr<leaves::ChargingStation> station_;
  adapters::RosInteraction interaction_;
  adapters::RosFace face_;
  adapters::VisitorFeed visitors_;
  SitePhrases phrases_;
  adapters::RosProcessManager processes_;
  adapters::RosSupervisors supervisors_;
  adapters::RosRecoveryLog recoveries_;
  RobotFigures figures_;  // before the trees, which it listens to
  FacePictures face_pictures_;
  TreeLink link_;
  ros::Publisher status_, ways_, heartbeat_, diagnostics_;
  std::unique_ptr<TreeRunner> application_;
  std::unique_ptr<TreeRunner> monitor_;
  NoteLimit note_limit_;
  std::vector<ros::Subscriber> subscribers_;
  std::optional<adapters::PoseFeed> pose_feed_;
  std::optional<adapters::PeopleFeed> people_feed_;
  std::optional<adapters::DutyFeed> duty_feed_;
  ros::WallTimer heart_;
};

// Until SIGTERM or SIGINT, which are blocked in all threads; false if ROS ended first, for example
// because another node has taken our name.
bool WaitForSignal(const sigset_t& signals) {
  const timespec moment{0, 200'000'000};
  while (sigtimedwait(&signals, nullptr, &moment) < 0) {
    if (!ros::ok()) return false;
  }
  return true;
}

int Main(int argc, char** argv) {
  ros::init(argc, argv, "coppice_robot", ros::init_options::NoSigintHandler);
  const Options options = ParseOptions(RobotCommand(), {argv + 1, argv + argc});
  if (options.exit) return *options.exit;
  if (!FindMaster("coppice-robot")) return 2;
  sigset_t signals;  // blocked in all threads; taken below by the main thread
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  bool asked_to_end = false;
  ros::NodeHandle node;
  ros::AsyncSpinner spinner(2);
  try {
    Robot robot(node, options);
    spinner.start();
    robot.Start();
    asked_to_end = WaitForSignal(signals);
    robot.Stop();
    spinner.stop();
  } catch (const std::exception& error) {
    std::cerr << "coppice-robot: " << error.what() << "\n";
    return 2;
  }
  ros::shutdown();
  if (asked_to_end) return 0;
  std::cerr << "coppice-robot: its ROS node was shut down from outside\n";
  return 1;
}

}  // namespace
}  // namespace coppice::robot

int main(int argc, char** argv) { return coppice::robot::Main(argc, argv); }
