// Faults of the computers that the programs run on: load, memory, disk, logger, the clock of a
// second computer, the network to it.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include "tests/support/folders.h"
#include "tests/system/fault_case.h"
#include "tests/system/second_host.h"
#include "tests/system/small_disk.h"

namespace coppice::robot {
namespace {

constexpr double kMemoryHog = 0.10;  // of all memory, more than is used when the robot runs
#ifdef __SANITIZE_ADDRESS__
constexpr double kRobot = 4e6;  // kB, that its programs take, with what guards their memory
#else
constexpr double kRobot = 0.5e6;
#endif
constexpr int kTimePort = 1123;

const std::string kTestPrograms = BinaryFolder() + "/tests/bin/";
const std::string kPrograms = BinaryFolder() + "/bin/";

// kB, of /proc/meminfo.
double Memory(const std::string& field) {
  std::ifstream file("/proc/meminfo");
  std::string name;
  double value = 0;
  while (file >> name >> value) {
    if (name == field + ":") return value;
    file.ignore(100, '\n');
  }
  return 0;
}

double MemoryUsed() { return 1 - Memory("MemAvailable") / Memory("MemTotal"); }

// Memory that is really taken, until that share of all memory is in use.
class MemoryHog {
 public:
  explicit MemoryHog(double until)
      : size_(static_cast<std::size_t>(std::max(0.01, until - MemoryUsed()) * Memory("MemTotal") *
                                       1024)) {
    memory_ = mmap(nullptr, size_, PROT_READ | PROT_WRITE,
                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_POPULATE, -1, 0);
    EXPECT_NE(memory_, MAP_FAILED);
  }
  ~MemoryHog() { munmap(memory_, size_); }

 private:
  std::size_t size_;
  void* memory_;
};

const char kProcesses[] = R"(processes:
  - name: laser_driver
    command: ["${bin}/laser_driver"]
    node: /laser_driver
    depends: [simulator]

  - name: logger
    command: [/usr/lib/rosbag/record, "--chunksize=16", -O, "${record}/log.bag",
              /scan, /odom, "__name:=logger"]
    node: /logger
    depends: [laser_driver]
)";

const char kSecondMonitor[] = R"(
  - name: second_monitor
    command: ["${bin}/coppice-system-monitor", --config, "${config}/monitors.yaml",
              --host, second, "__name:=second_system_monitor"]
    host: second
    node: /second_system_monitor
    depends: [health_aggregator]

)";

class ComputerFaults : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    disk_ = std::make_unique<SmallDisk>();
    host_ = std::make_unique<SecondHost>();
    rig_ = std::make_unique<RobotRig>(Options());
    if (host_->error().empty()) SetClock(0);
    ASSERT_TRUE(rig_->Start());
  }
  static void TearDownTestSuite() {
    rig_.reset();
    time_server_ = {};
    host_.reset();
    disk_.reset();
  }

  // What the computers' monitors are to look at instead of what a robot's do.
  static std::vector<ConfigEdit> Watches() {
    const double used = used_at_start_;
    std::ostringstream own;
    own << "    period: 0.5\n"
        << "    window: 2\n"
        << "    ask_period: 1\n"
        << "    deadline: 0.5\n"
        << "    memory: {used: {warn: [none, " << used + kMemoryHog * 0.5 << "], error: [none, "
        << used + kMemoryHog * 0.7 << "], consecutive: 2}}\n"
        << "    disks: [{path: \"" << disk_->path().string()
        << "\", used: {warn: [none, 0.7], error: [none, 0.95]}}]";
    std::vector<ConfigEdit> edits = {
        {"monitors.yaml",
         "    memory: {used: {warn: [none, 0.85], error: [none, 0.95], consecutive: 3}}\n"
         "    disks: [{path: /, used: {warn: [none, 0.9], error: [none, 0.97]}}]",
         own.str()},
        {"monitors.yaml", "processes: [{node: /simulator}",
         "processes: [{node: /laser_driver, cpu: " + Busy() + "}"},
        {"monitors.yaml", "      - {name: record,",
         "      - {name: bag, path: \"" + LogFile() +
             "\", node: /logger, staleness: 4}\n      - {name: record,"}};
    if (!host_->error().empty()) return edits;
    // The second computer itself is found by the programs on it.
    edits.push_back({"monitors.yaml", "clocks: [{host: \"*\",",
                     "clocks: [{host: \"*\", port: " + std::to_string(kTimePort) + ","});
    return edits;
  }

  // Of all cores. The driver at its work takes 0.02 of one; who burns one beside all that runs on a
  // busy computer gets a part of it.
  static std::string Busy() {
    const double core = 1.0 / std::max(1U, std::thread::hardware_concurrency());
    return "{warn: [none, " + std::to_string(0.08 * core) + "], error: [none, " +
           std::to_string(0.15 * core) + "], consecutive: 3}";
  }

  static std::string LogFile() {
    return BinaryFolder() + "/tests/system/computer_faults/log.bag.active";
  }

  static RigOptions Options() {
    RigOptions options;
    options.name = "computer_faults";
    options.start = "2 0 0";
    options.variables = {{"speed", "1"}, {"seed", "9"}};
    options.programs = {{"laser_driver", kTestPrograms + "laser_driver"}};
    options.edits = {
        {"robot.yaml", "\"_speed:=", "\"/scan:=/simulation/scan\", \"_speed:="},
        {"robot.yaml", "processes:\n", kProcesses},
        {"robot.yaml", "operating: [simulator,", "operating: [simulator, laser_driver, logger,"},
        {"monitors.yaml", "topic: /scan, node: /simulator", "topic: /scan, node: /laser_driver"}};
    for (ConfigEdit& edit : Watches()) options.edits.push_back(std::move(edit));
    if (host_->error().empty()) AddSecondHost(options);
    return options;
  }

  static void AddSecondHost(RigOptions& options) {
    options.address = host_->own_address();
    std::string words;
    for (const std::string& word : host_->transport()) {
      words += (words.empty() ? "'" : ", '") + word + "'";
    }
    options.edits.push_back({"robot.yaml", "processes:\n",
                             "hosts:\n  second: {command: [" + words + "], shell: no, bin: \"" +
                                 kPrograms + "\", address: " + host_->address() +
                                 "}\n\nprocesses:\n" + kSecondMonitor});
    options.edits.push_back(
        {"robot.yaml", "operating: [simulator,", "operating: [simulator, second_monitor,"});
    options.edits.push_back(
        {"monitors.yaml", "    sources: &all_sources\n",
         "    sources: &all_sources\n      - {source: /second_system_monitor, period: 0.5, "
         "host: second}\n"});
  }

  // The second computer's clock is that much ahead from now on.
  static void SetClock(double offset) {
    time_server_ = {};
    std::vector<std::string> command = host_->prefix();
    for (const std::string& word :
         {kPrograms + "coppice-system-monitor", std::string("--serve-time"),
          std::to_string(kTimePort), std::string("--address"), host_->address(),
          std::string("--clock-offset"), std::to_string(offset)}) {
      command.push_back(word);
    }
    time_server_ = ChildProcess(command, BinaryFolder() + "/tests/time_server.log");
  }

  static const double used_at_start_;
  static std::unique_ptr<SmallDisk> disk_;
  static std::unique_ptr<SecondHost> host_;
  static ChildProcess time_server_;
  static std::unique_ptr<RobotRig> rig_;
};

const double ComputerFaults::used_at_start_ = MemoryUsed() + kRobot / Memory("MemTotal");
std::unique_ptr<SmallDisk> ComputerFaults::disk_;
std::unique_ptr<SecondHost> ComputerFaults::host_;
ChildProcess ComputerFaults::time_server_;
std::unique_ptr<RobotRig> ComputerFaults::rig_;

TEST_F(ComputerFaults, AProgramThatBurnsACoreIsSeen) {
  FaultCase fault(*rig_, "CPU hog", "the laser driver burns a core");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGHUP));
  fault.ExpectDetected("process", "/laser_driver cpu", 8);
  fault.ExpectTold("process", "/laser_driver cpu");
  ASSERT_TRUE(rig_->Signal("laser_driver", SIGHUP));
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

TEST_F(ComputerFaults, MemoryThatRunsOutIsSeen) {
  FaultCase fault(*rig_, "RAM hog", "a program takes 10 % of the memory");
  auto hog = std::make_unique<MemoryHog>(used_at_start_ + kMemoryHog);
  fault.ExpectDetected("memory", "used", 15);  // taking it takes seconds
  fault.ExpectTold("memory", "used");
  hog.reset();
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

TEST_F(ComputerFaults, AFullDiskIsSeen) {
  FaultCase fault(*rig_, "disk full", "a small file system is filled to the last block");
  disk_->Fill();
  fault.ExpectDetected("disk", disk_->path().string(), 3);
  fault.ExpectTold("disk", disk_->path().string());
  disk_->Free();
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

TEST_F(ComputerFaults, ALoggerThatNoLongerWritesIsRestarted) {
  FaultCase fault(*rig_, "logger down", "SIGSTOP to the program that records");
  ASSERT_TRUE(rig_->Signal("logger", SIGSTOP));
  fault.ExpectDetected("logger", "bag", 10);
  fault.ExpectRecovery("restart node", "/logger", coppice_msgs::RecoveryEvent::SUCCEEDED);
  fault.ExpectRestarted("logger");
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({"logger"});
  fault.ExpectNobodyAsked();
}

TEST_F(ComputerFaults, AClockThatIsOffByThreeSecondsIsSeen) {
  if (!host_->error().empty()) GTEST_SKIP() << "no network namespaces: " << host_->error();
  FaultCase fault(*rig_, "clock off by 3 s", "the second computer's clock is 3 s ahead");
  SetClock(3);
  fault.ExpectDetected("clock", "second", 8);
  fault.ExpectTold("clock", "second");
  SetClock(0);
  fault.ExpectNominal();
  fault.ExpectOnlyRestarted({});
  fault.ExpectNobodyAsked();
}

// Nobody knows what runs there meanwhile; here everything runs on.
TEST_F(ComputerFaults, ANetworkThatIsCutIsSeenAndHealsWithTheLink) {
  if (!host_->error().empty()) GTEST_SKIP() << "no network namespaces: " << host_->error();
  FaultCase fault(*rig_, "network cut", "the link to the second computer is taken down");
  host_->Cut();
  fault.ExpectDetected("network", "host second", 8);
  fault.ExpectDetected("node", "/second_system_monitor", 8);
  // At once, and not when the restart of what runs there has been given up after a minute.
  fault.ExpectTold("network", "host second", 20);
  EXPECT_TRUE(rig_->WaitFor(
      [](const RobotState& state) {
        const auto process = state.processes().find("second_monitor");
        return process != state.processes().end() &&
               process->second.state == coppice_msgs::ProcessState::UNREACHABLE;
      },
      60));
  host_->Join();
  fault.ExpectNominal(120);
  fault.ExpectOnlyRestarted({"second_monitor"});
  fault.ExpectNobodyAsked();
  fault.AddRecovery("its program is UNREACHABLE, and started anew with the link");
}

}  // namespace
}  // namespace coppice::robot
