// The whole robot at once, as `./dev demo` runs it: ROS master, simulated robot, monitors, process
// supervisor, both trees, live sockets, records. What happened is read from the records, not from
// log lines.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/play/verify.h"
#include "robot_app/app/run_summary.h"
#include "robot_app/common/child_process.h"
#include "robot_app/processes/launch/ros_master.h"
#include "tests/support/folders.h"

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

std::string Contents(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

// The engine does the same once more, event for event, with what the record says came from outside.
void ExpectSameWhenRunAgain(const fs::path& record) {
  Diagnostics diagnostics;
  const std::optional<coppice::Recording> run = LoadRecording(record.string(), diagnostics);
  ASSERT_TRUE(run) << diagnostics.ToString();
  const Verification verification = Verify(*run, {}, diagnostics);
  EXPECT_TRUE(verification.is_the_same())
      << record << "\n"
      << PrintVerification(verification, run->start()) << diagnostics.ToString();
  EXPECT_EQ(verification.skipped_ticks, 0u);
  EXPECT_GT(verification.ticks, 100u);
}

TEST(Robot, LeadsAVisitorAndRecoversFromADeadNodeAndABlockedCorridorOnItsPatrol) {
  const fs::path folder = fs::path(BinaryFolder()) / "tests" / "system_run";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string live_port = std::to_string(processes::FreePort(4));
  ChildProcess demo({BinaryFolder() + "/bin/coppice-demo", "--no-editor", "--run", folder.string(),
                     "--rounds", "1", "--stops", "4", "--speed", "6", "--live-port", live_port},
                    (folder / "demo.log").string());
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(540);
  while (demo.IsRunning() && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(demo.Stop(std::chrono::seconds(30)), 0) << Contents(folder / "demo.log");

  const RunSummary run = SummarizeFiles((folder / "application.coppice").string(),
                                        (folder / "monitor.coppice").string());
  EXPECT_NE(Contents(folder / "demo.log").find("the visitor was led to office_103"),
            std::string::npos);
  EXPECT_TRUE(run.problems.empty()) << run.problems.front();
  // More if the visitor came in the middle of the round, or at its end: then it is begun anew.
  EXPECT_GE(run.rounds, 1);
  EXPECT_GE(run.stops, 4);
  EXPECT_TRUE(run.docked);
  EXPECT_EQ(run.injected.size(), 2u);
  EXPECT_GE(run.Recovery("restart node").succeeded, 1);
  EXPECT_GE(run.Recovery("wait and retry").succeeded + run.Recovery("move backwards").succeeded, 1);
  EXPECT_EQ(run.Recovery("navigation: ask").begun, 0);
  EXPECT_GT(run.application.ticks, 100u);
  EXPECT_GT(run.monitor.ticks, 100u);
  ExpectSameWhenRunAgain(folder / "application.coppice");
  ExpectSameWhenRunAgain(folder / "monitor.coppice");
}

}  // namespace
}  // namespace coppice::robot
