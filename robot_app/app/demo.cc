#include "robot_app/app/demo.h"

#include <coppice_msgs/HearFile.h>
#include <coppice_msgs/InjectFault.h>
#include <coppice_msgs/Person.h>
#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "robot_app/app/demo_console.h"
#include "robot_app/app/robot_watch.h"
#include "robot_app/app/run_summary.h"
#include "robot_app/common/child_process.h"
#include "robot_app/speech/mouth/synthesizer.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

// What a visitor says, and what else when he is not understood.
constexpr const char* kWishes[] = {"Please take me to office one oh three.",
                                   "Take me to room one oh three.",
                                   "Can you take me to office one oh three?"};
constexpr char kVisitor[] = "en-us+f2";  // a voice of espeak-ng
constexpr char kFollower[] = "anna";     // who follows the robot where it looks back

std::string LastLine(const std::string& path) {
  std::ifstream file(path);
  std::string line, last;
  while (std::getline(file, line)) {
    if (!line.empty()) last = line;
  }
  return last;
}

// What is wrong with the robot; not the load of its computer, which is as busy as the simulation
// and whatever else runs there make it.
std::vector<std::string> FaultsOf(const RobotView& view) {
  std::vector<std::string> faults = view.errors;
  const auto is_load = [](const std::string& error) { return error.rfind("cpu load", 0) == 0; };
  faults.erase(std::remove_if(faults.begin(), faults.end(), is_load), faults.end());
  return faults;
}

// A failure of the demonstration itself; the summary is still printed.
struct DemoFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Demo {
 public:
  Demo(const DemoSettings& settings, const volatile int& interrupted)
      : settings_(settings), interrupted_(interrupted) {}

  int Run() {
    fs::create_directories(settings_.folder / "logs");
    std::string failure;
    try {
      BringMap();
      StartEverything();
      Patrol();
    } catch (const DemoFailed& error) {
      failure = error.what();
    }
    const bool clean = StopEverything();
    return Report(failure, clean);
  }

 private:
  // The map that the robot made of the institute on a patrol before, where it keeps its maps; a run
  // that has one already keeps it.
  void BringMap() {
    constexpr auto kKeep = fs::copy_options::skip_existing;
    const fs::path to = settings_.folder / "institute";
    fs::create_directories(to);
    for (const auto& file :
         fs::directory_iterator(settings_.source / "robot_app/config/sites/institute")) {
      const bool is_of_map =
          file.path().filename() == "map.yaml" || file.path().extension() == ".pgm";
      if (is_of_map) fs::copy_file(file, to / file.path().filename(), kKeep);
    }
  }

  void StartEverything() {
    console_.Step("starting ROS, the simulated robot, monitors and trees");
    if (settings_.editor) StartEditor();
    const fs::path port_file = settings_.folder / "ros_port";
    supervisor_ = ChildProcess(SupervisorCommand(port_file), Log("supervisor"));
    const std::string port = WaitForPort(port_file);
    setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + port).c_str(), 1);
    setenv("ROS_IP", "127.0.0.1", 1);
    console_.Tell("ROS master at port " + port + ", logs in " +
                  (settings_.folder / "logs").string());
    console_.Tell("it drives on the map that it made itself on a patrol before");

    int no_arguments = 0;
    ros::init(no_arguments, nullptr, "coppice_demo",
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    node_ = std::make_unique<ros::NodeHandle>();
    spinner_ = std::make_unique<ros::AsyncSpinner>(1);
    spinner_->start();
    note_ = node_->advertise<std_msgs::String>("/coppice/note", 10, true);
    speed_ = node_->advertise<std_msgs::Float64>("/simulation/speed", 1, true);
    watch_ = std::make_unique<RobotWatch>(*node_);
    WaitOrFail("all programs to be ready", 60, [this](const RobotView& view) {
      Remember(view);
      return view.application == "RUNNING";
    });
    console_.Tell("live sockets: application 127.0.0.1:" + settings_.live_port +
                  ", monitor 127.0.0.1:" + MonitorPort());
  }

  void Patrol() {
    console_.Step("patrol: " + settings_.rounds + " rounds of " + settings_.stops + " stops");
    if (settings_.perception) CallSimulation("follow_robot", kFollower);
    WaitOrFail("the robot to leave its station", 120,
               [](const RobotView& view) { return view.has_goal && view.distance > 5; });
    LeadAVisitor();
    if (settings_.perception) CallSimulation("leave_robot", kFollower);
    HangNavigation();
    BlockCorridor();
    WaitOrFail("the application to end", 900,
               [](const RobotView& view) { return view.application != "RUNNING"; });
    console_.Tell("application: " + watch_->view().application);
    // Long enough for the monitor tree to see that all is well, and for the records to be complete.
    WaitOrFail("the robot to be without faults", 60,
               [](const RobotView& view) { return FaultsOf(view).empty(); });
  }

  // What he says comes by a file instead of the microphone.
  void LeadAVisitor() {
    const bool is_led = std::any_of(std::begin(kWishes), std::end(kWishes),
                                    [this](const char* wish) { return AskToBeLed(wish); });
    if (!is_led) throw DemoFailed("it did not understand the visitor");
    WaitOrFail("the visitor to be led", 300, [](const RobotView& view) {
      return !view.outcome.empty() || view.application != "RUNNING";
    });
    const RobotView led = watch_->view();
    if (led.outcome.empty()) throw DemoFailed("the application ended before the visitor was led");
    if (led.outcome != "arrived") throw DemoFailed("leading the visitor ended: " + led.outcome);
    console_.Tell("the visitor was led to " + led.led_to);
  }

  // Whether it was understood.
  bool AskToBeLed(const std::string& wish) {
    console_.Step("a visitor says: \"" + wish + "\"");
    const auto spoken = speech::Synthesizer().Speak(wish, {kVisitor, 140});
    if (!spoken) throw DemoFailed("the visitor cannot speak: " + spoken.problem());
    const std::string file = (settings_.folder / "visitor.wav").string();
    if (const Outcome written = speech::WriteWav(file, spoken->sound); !written) {
      throw DemoFailed(written.problem());
    }
    const int answers = watch_->view().answers;
    const double speed = std::stod(settings_.speed);
    SetSpeed(std::min(speed, 1.0));
    LetHear(file);
    WaitOrFail("an answer", 60,
               [answers](const RobotView& view) { return view.answers > answers; });
    SetSpeed(speed);
    const RobotView answered = watch_->view();
    console_.Tell("heard: \"" + answered.heard + "\"; the robot: \"" + answered.answer + "\"");
    return !answered.led_to.empty();
  }

  // To understand takes seconds of the computer, in which a robot in a fast simulation would be at
  // the other end of the floor, or at the end of its patrol.
  void SetSpeed(double speed) {
    std_msgs::Float64 message;
    message.data = speed;
    speed_.publish(message);
  }

  // It hears nothing while it speaks itself.
  void LetHear(const std::string& file) {
    coppice_msgs::HearFile service;
    service.request.path = file;
    service.request.who = "visitor";
    for (int attempts = 0; attempts < 60; ++attempts) {
      if (ros::service::call("/speech/hear_file", service) && service.response.ok) return;
      watch_->WaitFor([](const RobotView&) { return false; }, 0.5);
    }
    throw DemoFailed("the robot does not hear: " + service.response.message);
  }

  void HangNavigation() {
    const int before = watch_->view().pids.at("navigation");
    console_.Step("fault 1: /navigation hangs (SIGSTOP to pid " + std::to_string(before) + ")");
    Inject("hang_node", "/navigation");
    WaitOrFail("the monitor to notice", 60,
               [](const RobotView& view) { return !FaultsOf(view).empty(); });
    console_.Tell("noticed: " + FirstFault());
    WaitOrFail("the monitor tree to restart it", 120, [before](const RobotView& view) {
      const auto now = view.pids.find("navigation");
      return now != view.pids.end() && now->second != before && view.ready.at("navigation") &&
             FaultsOf(view).empty();
    });
    console_.Tell("recovered: /navigation has pid " +
                  std::to_string(watch_->view().pids.at("navigation")));
  }

  // Waits for a drive that still has to pass one of the places, then closes it until that is seen.
  void BlockCorridor() {
    std::string place;
    WaitOrFail("a drive along the corridor", 600, [&place](const RobotView& view) {
      place = PlaceAhead(view);
      return !place.empty();
    });
    console_.Step("fault 2: " + place + " is blocked");
    Inject("block_corridor", place);
    WaitOrFail("the monitor to notice", 240, [](const RobotView& view) {
      for (const std::string& error : view.errors) {
        if (error.rfind("navigation", 0) == 0) return true;
      }
      return false;
    });
    console_.Tell("noticed: " + FirstFault() + "; the way is cleared again");
    CallSimulation("clear_corridor", place);
    WaitOrFail("the monitor tree to recover", 240,
               [](const RobotView& view) { return FaultsOf(view).empty(); });
    console_.Tell("recovered: the robot drives on");
  }

  std::string FirstFault() const {
    const std::vector<std::string> faults = FaultsOf(watch_->view());
    return faults.empty() ? "it is over already" : faults.front();
  }

  // A place of the floor that lies between the robot and its goal, not too near to either; or
  // empty.
  static std::string PlaceAhead(const RobotView& view) {
    const std::map<std::string, double> places = {{"corridor_west", 10}, {"corridor_east", 30}};
    for (const auto& [name, x] : places) {  // [m] along the corridor
      const bool eastward = view.x < x - 5 && view.goal_x > x + 2;
      const bool westward = view.x > x + 5 && view.goal_x < x - 2;
      if (view.has_goal && (eastward || westward)) return name;
    }
    return {};
  }

  void Inject(const std::string& fault, const std::string& target) {
    CallSimulation(fault, target);
    std_msgs::String note;
    note.data = "fault injected: " + fault + " " + target;
    note_.publish(note);
  }

  // A place cannot be blocked while somebody stands in it: then it is tried again for a while.
  void CallSimulation(const std::string& fault, const std::string& target) {
    coppice_msgs::InjectFault service;
    service.request.fault = fault;
    service.request.target = target;
    for (int attempts = 0; attempts < 20 && !service.response.ok; ++attempts) {
      if (attempts > 0) watch_->WaitFor([](const RobotView&) { return false; }, 0.5);
      ros::service::call("/simulation/inject_fault", service);
    }
    if (!service.response.ok) {
      throw DemoFailed("fault " + fault + " was not injected: " + service.response.message);
    }
  }

  void WaitOrFail(const std::string& what, double seconds,
                  const std::function<bool(const RobotView&)>& predicate) {
    const auto still_there = [this](const RobotView& view) {
      Remember(view);
      console_.Progress(view);
      if (!supervisor_.IsRunning()) throw DemoFailed("the process supervisor has ended");
      if (!view.given_up.empty()) {
        const std::string log = Log(view.given_up.front());
        throw DemoFailed("program " + view.given_up.front() + " does not stay up (" + log +
                         "): " + LastLine(log));
      }
      if (interrupted_ != 0) throw DemoFailed("interrupted");
    };
    if (watch_->WaitFor(predicate, seconds, still_there)) return;
    throw DemoFailed("waited " + std::to_string(static_cast<int>(seconds)) + " s for " + what);
  }

  void Remember(const RobotView& view) {
    for (const auto& [name, pid] : view.pids) pids_.insert(pid);
  }

  std::vector<std::string> SupervisorCommand(const fs::path& port_file) const {
    std::vector<std::string> command = {(settings_.programs / "coppice-supervisor").string(),
                                        "--config",
                                        (settings_.source / "robot_app/config/robot.yaml").string(),
                                        "--port",
                                        "0",
                                        "--port-file",
                                        port_file.string(),
                                        "--logs",
                                        (settings_.folder / "logs").string()};
    const std::vector<std::pair<std::string, std::string>> values = {
        {"bin", settings_.programs.string()},
        {"source", settings_.source.string()},
        {"record", settings_.folder.string()},
        {"speed", settings_.speed},
        {"perception", settings_.perception ? "yes" : "no"},
        {"seed", settings_.seed},
        {"rounds", settings_.rounds},
        {"stops", settings_.stops},
        {"live_port", settings_.live_port}};
    for (const auto& [name, value] : values) {
      command.push_back("--set");
      command.push_back(name + "=" + value);
    }
    return command;
  }

  std::string WaitForPort(const fs::path& port_file) {
    for (int i = 0; i < 300; ++i) {
      std::ifstream file(port_file);
      std::string port;
      if (file >> port) return port;
      if (!supervisor_.IsRunning()) break;
      usleep(100000);
    }
    std::ifstream log(Log("supervisor"));
    std::ostringstream text;
    text << log.rdbuf();
    throw DemoFailed("the process supervisor did not start:\n" + text.str());
  }

  // Waits by itself for the trees to come up, so that there is something to see from the beginning.
  void StartEditor() {
    const bool window = std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
    std::vector<std::string> command = {(settings_.programs / "coppice-edit").string(),
                                        "--connect",
                                        "127.0.0.1:" + settings_.live_port,
                                        "--connect",
                                        "127.0.0.1:" + MonitorPort(),
                                        "--picture",
                                        Picture().string(),
                                        "--every",
                                        "2"};
    if (!window) {
      command.insert(command.begin(), {"xvfb-run", "-a", "-s", "-screen 0 1920x1200x24"});
      command.insert(command.end(), {"--size", "1920x1200"});
    }
    editor_ = ChildProcess(command, Log("editor"));
    console_.Tell(window ? "the editor opens and shows both trees as soon as they run"
                         : "no display: what the editor shows is painted every 2 s into " +
                               Picture().string());
  }

  // True if nothing is left behind.
  bool StopEverything() {
    console_.Step("stopping");
    if (watch_) {
      Remember(watch_->view());
      distance_ = watch_->view().distance;
      crowd_ = watch_->view().crowd;
    }
    const bool editor_was_there = editor_.pid() == 0 || editor_.IsRunning();
    if (!editor_was_there) console_.Tell("the editor has ended early; see " + Log("editor"));
    editor_.Stop(std::chrono::seconds(5));
    watch_.reset();
    if (spinner_) spinner_->stop();
    if (ros::isStarted()) ros::shutdown();
    const int status = supervisor_.Stop(std::chrono::seconds(20));
    if (status != 0) console_.Tell("the supervisor ended with status " + std::to_string(status));
    bool clean = status == 0 && editor_was_there;
    for (const pid_t pid : pids_) {
      if (!ProcessExists(pid)) continue;
      console_.Tell("left behind: process " + std::to_string(pid));
      clean = false;
    }
    return clean;
  }

  int Report(const std::string& failure, bool clean) {
    const RunSummary summary = SummarizeFiles((settings_.folder / "application.coppice").string(),
                                              (settings_.folder / "monitor.coppice").string());
    std::cout << "\n"
              << ToTable(summary, distance_) << "people          "
              << (settings_.perception ? ToText(crowd_)
                                       : "not looked for: nobody can be followed faster than real "
                                         "time (--speed 1)")
              << "\n";
    std::cout << "\nrecorded run   " << (settings_.folder / "application.coppice").string()
              << "\n               " << (settings_.folder / "monitor.coppice").string() << "\n";
    if (settings_.editor) std::cout << "editor picture " << Picture().string() << "\n";
    std::cout << "look at it with: coppice replay FILE\n\n";

    std::vector<std::string> problems = summary.problems;
    if (!failure.empty()) problems.push_back(failure);
    if (!clean) problems.push_back("not everything ended as it should");
    const int navigation = summary.Recovery("wait and retry").succeeded +
                           summary.Recovery("move backwards").succeeded +
                           summary.Recovery("navigation: ask").succeeded;
    if (summary.Recovery("restart node").succeeded == 0) {
      problems.push_back("the record shows no successful restart of a node");
    }
    if (!summary.docked) problems.push_back("the robot did not come home");
    if (navigation == 0) problems.push_back("the record shows no recovery of the navigation");
    if (settings_.editor && !fs::exists(Picture()))
      problems.push_back("the editor saved no picture");
    for (const std::string& problem : problems) std::cout << "PROBLEM: " << problem << "\n";
    std::cout << (problems.empty() ? "The demonstration went well.\n"
                                   : "The demonstration did NOT go well.\n");
    return problems.empty() ? 0 : 1;
  }

  std::string Log(const std::string& name) const {
    return (settings_.folder / "logs" / (name + ".log")).string();
  }
  fs::path Picture() const { return settings_.folder / "editor.png"; }
  std::string MonitorPort() const { return std::to_string(std::stoi(settings_.live_port) + 2); }

 private:
  const DemoSettings settings_;
  const volatile int& interrupted_;
  DemoConsole console_{std::cout, isatty(STDOUT_FILENO) == 1};
  ChildProcess supervisor_;
  ChildProcess editor_;
  std::unique_ptr<ros::NodeHandle> node_;
  std::unique_ptr<ros::AsyncSpinner> spinner_;
  ros::Publisher note_;
  ros::Publisher speed_;  // of the simulation
  std::unique_ptr<RobotWatch> watch_;
  std::set<pid_t> pids_;
  double distance_ = 0;  // m
  CrowdFigures crowd_;
};

}  // namespace

int RunDemo(const DemoSettings& settings, const volatile int& interrupted) {
  return Demo(settings, interrupted).Run();
}

}  // namespace coppice::robot
