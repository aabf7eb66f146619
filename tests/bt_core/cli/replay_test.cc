#include "bt_core/cli/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "bt_core/record/recorder.h"
#include "tests/bt_core/record/recorded_tree.h"
#include "tests/bt_core/record/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() {
    LeafScript script;
    SimulatedClock clock(100s);
    Executor executor(RecordedProgram(script), clock);
    RecorderOptions options;
    options.metadata = {{"robot", "sobi-1"}};
    Recorder recorder(executor, path(), options);
    executor.Tick();
    clock.Advance(1s);
    recorder.Note(clock.Now(), "fault", "laser unplugged");
    script.status = [] { return Status::kSuccess; };
    script.write = true;
    script.number = 42;
    script.message = "found \"it\"";
    clock.Advance(1s);
    executor.Tick();
    recorder.Close();
  }

  std::string path() const { return folder_.Path("run.coppice"); }

  int Run(std::vector<std::string> arguments) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int status = RunReplay(arguments);
    out_ = ::testing::internal::GetCapturedStdout();
    error_ = ::testing::internal::GetCapturedStderr();
    return status;
  }

  const TemporaryFolder folder_;
  std::string out_;
  std::string error_;
};

TEST_F(ReplayTest, PrintsWhatHappened) {
  EXPECT_EQ(Run({path()}), 0);
  EXPECT_THAT(out_, HasSubstr("tree Main: 5 nodes"));
  EXPECT_THAT(out_, HasSubstr("robot: sobi-1\n"));
  EXPECT_THAT(out_, HasSubstr("      0.000000  tick 1  first  IDLE -> RUNNING\n"));
  EXPECT_THAT(out_, HasSubstr("      1.000000  note [fault] laser unplugged\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  tick 2  Main{number} = 42\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  tick 2  first  RUNNING -> SUCCESS\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  tick 2  first: found \"it\"\n"));
  EXPECT_THAT(out_, HasSubstr("2 ticks with events in 2.000000 s"));
  EXPECT_THAT(out_, HasSubstr("  first: 1 successes, 0 failures\n"));
  EXPECT_EQ(error_, "");
}

TEST_F(ReplayTest, ShowsOnlyTheNodesThatAreAskedFor) {
  EXPECT_EQ(Run({path(), "--node", "sec*"}), 0);
  EXPECT_THAT(out_, HasSubstr("second  IDLE -> SUCCESS"));
  EXPECT_THAT(out_, Not(HasSubstr("first  ")));
}

TEST_F(ReplayTest, ShowsOnlyThePartThatIsAskedFor) {
  EXPECT_EQ(Run({path(), "--from", "0.5", "--to", "1.5"}), 0);
  EXPECT_THAT(out_, HasSubstr("laser unplugged"));
  EXPECT_THAT(out_, Not(HasSubstr("tick 1 ")));
  EXPECT_THAT(out_, Not(HasSubstr("tick 2 ")));
}

TEST_F(ReplayTest, SaysWhereARecordIsCutOff) {
  const std::string bytes = ReadFile(path());
  WriteFile(folder_.Path("torn"), bytes.substr(0, bytes.size() - 1));
  EXPECT_EQ(Run({folder_.Path("torn")}), 1);
  EXPECT_THAT(out_, HasSubstr("DAMAGE at byte "));
  EXPECT_THAT(out_, HasSubstr("not closed"));
  EXPECT_EQ(Run({folder_.Path("torn"), "--json"}), 1);
  EXPECT_THAT(out_, HasSubstr("{\"type\":\"damage\",\"offset\":"));
}

TEST_F(ReplayTest, RefusesWrongUsageAndOtherFiles) {
  EXPECT_EQ(Run({}), 2);
  EXPECT_THAT(error_, HasSubstr("expected one file"));
  EXPECT_EQ(Run({path(), path()}), 2);
  EXPECT_EQ(Run({path(), "--form", "1"}), 2);
  EXPECT_EQ(Run({path(), "--from", "noon"}), 2);
  EXPECT_THAT(error_, HasSubstr("--from needs a number of seconds, not \"noon\""));
  EXPECT_EQ(Run({path(), "--to", ""}), 2);
  WriteFile(folder_.Path("text"), "not a record at all");
  EXPECT_EQ(Run({folder_.Path("text")}), 2);
  EXPECT_THAT(error_, HasSubstr("not a Coppice record"));
}

}  // namespace
}  // namespace coppice
