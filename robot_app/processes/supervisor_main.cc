// coppice-supervisor: starts a ROS master and the robot's programs, keeps track of them, and leaves
// nothing behind. See supervisor_program.h for its topics and services.
//
// When the whole stack has to begin anew, the program replaces itself: a ROS node cannot move to
// another master in its lifetime.
#include <ros/ros.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "robot_app/processes/config/supervisor_settings.h"
#include "robot_app/processes/launch/never_wait.h"
#include "robot_app/processes/launch/survivors.h"
#include "robot_app/processes/supervisor_program.h"

namespace coppice::robot::processes {
namespace {

using Ending = SupervisorProgram::Ending;

constexpr Duration kMasterTimeout = std::chrono::seconds(20);
constexpr Duration kTimeToEnd = std::chrono::seconds(3);
constexpr Duration kTimeToCut = std::chrono::seconds(60);

volatile std::sig_atomic_t g_stop = 0;

int Fail(const std::string& message) {
  std::cerr << "coppice-supervisor: " << message << "\n";
  return 2;
}

// Ends our master, if it is ours. The last one to go.
void EndMaster(const RosMaster& master, PosixLauncher& launcher) {
  if (master.pid == 0) return;
  WallClock clock;
  const Time kill_at = clock.Now() + kTimeToEnd;
  launcher.Signal(master.pid, SIGTERM);
  bool ended = kill(master.pid, 0) != 0, killed = false;
  while (!ended) {
    launcher.Reap([&](int pid, int) { ended = ended || pid == master.pid; });
    if (!killed && clock.Now() >= kill_at) {
      launcher.Signal(master.pid, SIGKILL);
      killed = true;
    }
    ros::WallDuration(0.01).sleep();
  }
}

// What the disk could not take, for who begins anew in this process: a file that is nowhere.
// Whoever forgot how often it has begun anew would never ask a person.
constexpr char kHandedOver[] = "COPPICE_SUPERVISOR_MEMORY";  // the number of its descriptor

int HandOver(const std::string& unsaved) {
  if (unsaved.empty()) return -1;
  const int file = memfd_create("supervisor", 0);
  if (file < 0 || write(file, unsaved.data(), unsaved.size()) < 0) return -1;
  setenv(kHandedOver, std::to_string(file).c_str(), 1);
  return file;
}

std::string MemoryFile(const SupervisorSettings& settings) {
  const char* const file = std::getenv(kHandedOver);
  return file != nullptr ? std::string("/proc/self/fd/") + file : settings.state;
}

// Not for the programs that are started.
void ForgetHandedOver() {
  const char* const file = std::getenv(kHandedOver);
  if (file != nullptr) close(std::atoi(file));
  unsetenv(kHandedOver);
}

RobotConfig Load(const SupervisorSettings& settings, const std::string& site,
                 Diagnostics& diagnostics) {
  Variables variables = settings.variables;
  if (!site.empty()) variables["site"] = site;
  return LoadRobotConfig(settings.config, variables, diagnostics);
}

Outcome MakeFolder(const std::string& folder) {
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  return error ? Outcome(Problem{folder + ": cannot be made: " + error.message()}) : Outcome();
}

// Everything that is to begin at a site is looked at before anything ends at this one.
Outcome CheckComplete(const SupervisorSettings& settings, const std::string& site) {
  Diagnostics diagnostics;
  const RobotConfig config = Load(settings, site, diagnostics);
  if (diagnostics.has_errors()) return Problem{diagnostics.ToString()};
  return MakeFolder(config.site_folder);
}

// Where the robot is knows the memory, which is written as a whole: the old site or the new one.
RobotConfig LoadWhereItIs(const SupervisorSettings& settings, Diagnostics& diagnostics) {
  const Expected<SupervisorMemory> memory = LoadMemory(MemoryFile(settings), WallClock().Now());
  RobotConfig config = Load(settings, "", diagnostics);
  if (diagnostics.has_errors() || config.sites.empty() || !memory || memory->site.empty()) {
    return config;
  }
  if (memory->site == config.sites[config.site].name) return config;
  for (const SiteConfig& site : config.sites) {
    if (site.name == memory->site) return Load(settings, site.name, diagnostics);
  }
  std::cerr << "coppice-supervisor: there is no site \"" << memory->site << "\" any more\n";
  return config;
}

Ending RunNode(RobotConfig config, const SupervisorSettings& settings, const RosMaster& master,
               PosixLauncher& launcher, std::string& unsaved) {
  const Outcome made = MakeFolder(config.site_folder);  // without it nothing is learnt there
  if (!made) std::cerr << "coppice-supervisor: " << made.problem() << "\n";
  int no_arguments = 0;
  ros::init(no_arguments, nullptr, "supervisor", ros::init_options::NoSigintHandler);
  const Outcome set = SetParameters(master.address, config.parameters);  // it lives in their time
  if (!set) std::cerr << "coppice-supervisor: " << set.problem() << "\n";
  const char* token = std::getenv("COPPICE_SWITCH_OFF_TOKEN");
  SupervisorProgram program(std::move(config), launcher, master, settings.address, settings.state,
                            MemoryFile(settings), token ? token : "",
                            [&](const std::string& site) { return CheckComplete(settings, site); });
  ForgetHandedOver();
  const Ending ending = program.Run([] { return g_stop != 0; });
  unsaved = program.unsaved();
  ros::shutdown();
  return ending;
}

// What was counted stays; for the rest the robot begins afresh when a person has switched it on.
// If the power cannot be cut, it begins anew in its safe stop.
bool CutPowerAndForget(const RobotConfig& config, const SupervisorSettings& settings,
                       PosixLauncher& launcher) {
  Expected<SupervisorMemory> memory = LoadMemory(settings.state, WallClock().Now());
  if (!memory) memory = SupervisorMemory{};
  SupervisorMemory counters;
  counters.site = memory->site;
  counters.restarts = memory->restarts;
  KeepMemory(counters, settings.state);
  if (CutPower(config.switch_off, launcher, kTimeToCut)) return true;
  KeepMemory(*memory, settings.state);
  return false;
}

// Who says it at every start, as for the configuration, is believed at the next one.
void ForgetSiteOfCommandLine(const SupervisorSettings& settings) {
  Expected<SupervisorMemory> memory = LoadMemory(settings.state, WallClock().Now());
  if (!memory || settings.variables.count("site") == 0) return;
  memory->site.clear();
  KeepMemory(*memory, settings.state);
}

// A second start must not take the programs of the first for survivors. Where the file cannot be
// made (a folder that is missing or read-only) the robot runs nevertheless, as without its memory.
bool IsOnlyOne(const std::string& state) {
  const Expected<int> other = BecomeOnlyOne(state + ".lock", kTimeToEnd);
  if (!other) std::cerr << "coppice-supervisor: " << other.problem() << "\n";
  if (!other || *other == 0) return true;
  const std::string process = *other > 0 ? "process " + std::to_string(*other) : "another process";
  std::cerr << "coppice-supervisor: it runs already: " << process << " has the memory " << state
            << "\n";
  return false;
}

// The same program again, with the same port. Returns only if that fails.
int BeginAnew(std::vector<std::string> arguments, int port, const std::string& unsaved) {
  const int handed_over = HandOver(unsaved);
  arguments.insert(arguments.begin(), "coppice-supervisor");
  arguments.insert(arguments.end(), {"--port", std::to_string(port)});
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  for (int file = STDERR_FILENO + 1; file < static_cast<int>(sysconf(_SC_OPEN_MAX)); ++file) {
    if (file > 4096) break;
    if (file != handed_over) close(file);
  }
  execv("/proc/self/exe", pointers.data());
  return Fail("cannot begin anew");
}

// Before the master starts: it listens where its address is.
void UseAddress(const SupervisorSettings& settings) {
  if (!settings.address.empty()) {
    unsetenv("ROS_HOSTNAME");
    setenv("ROS_IP", settings.address.c_str(), 1);
  } else if (!getenv("ROS_HOSTNAME")) {
    setenv("ROS_IP", "127.0.0.1", 0);
  }
}

// Beginning with a configuration is a wish for the first start, not for one that goes on.
bool ChooseConfiguration(const SupervisorSettings& settings, RobotConfig& config) {
  if (settings.configuration.empty()) return true;
  ConfigurationSwitch chosen(config);
  const Expected<std::string> done =
      chosen.Request(settings.configuration, Hand::kTree,
                     [](std::size_t) { return Problem{"nothing is known at the start"}; });
  if (!done) std::cerr << "coppice-supervisor: " << done.problem() << "\n";
  config.initial = chosen.current();
  return done.ok();
}

int Main(const std::vector<std::string>& arguments) {
  const auto settings = ReadSupervisorSettings(
      arguments, std::filesystem::read_symlink("/proc/self/exe").parent_path());
  if (settings.exit) return *settings.exit;
  Diagnostics diagnostics;
  RobotConfig config = LoadWhereItIs(settings, diagnostics);
  std::cerr << diagnostics.ToString();
  if (diagnostics.has_errors() || !ChooseConfiguration(settings, config)) return 2;

  struct sigaction stop {};
  stop.sa_handler = [](int) { g_stop = 1; };
  sigaction(SIGTERM, &stop, nullptr);
  sigaction(SIGINT, &stop, nullptr);
  NeverWaitForReaders();
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // what our children leave behind comes to us
  NodeProbe::SilenceLibrary();
  PosixLauncher launcher(settings.logs, settings.state);
  if (!IsOnlyOne(settings.state)) return 2;
  const int survivors = KillOwned(settings.state, kTimeToEnd);
  if (survivors < 0) return Fail("programs of an earlier supervisor cannot be ended");
  if (survivors > 0) {
    std::cout << survivors << " processes of an earlier supervisor were ended" << std::endl;
  }
  UseAddress(settings);
  const Expected<RosMaster> found = FindOrStartMaster(settings.port, launcher, kMasterTimeout);
  if (!found) return Fail(found.problem());
  const RosMaster& master = *found;
  setenv("ROS_MASTER_URI", master.Uri().c_str(), 1);
  std::cout << "ROS master: port " << master.address.port << ", ROS_MASTER_URI=" << master.Uri()
            << ", logs in " << settings.logs << std::endl;
  if (!settings.port_file.empty()) std::ofstream(settings.port_file) << master.address.port;

  std::string unsaved;
  const Ending ending = RunNode(config, settings, master, launcher, unsaved);
  EndMaster(master, launcher);
  if (ending == Ending::kSwitchOff && CutPowerAndForget(config, settings, launcher)) return 0;
  if (ending == Ending::kNewStack || ending == Ending::kSwitchOff) {
    return BeginAnew(arguments, master.address.port, unsaved);
  }
  if (ending == Ending::kStopped) {
    ForgetSiteOfCommandLine(settings);
    return 0;
  }
  std::cerr << "coppice-supervisor: the ROS master ended again and again; everything was stopped\n";
  return 1;
}

}  // namespace
}  // namespace coppice::robot::processes

int main(int argc, char** argv) { return coppice::robot::processes::Main({argv + 1, argv + argc}); }
