#include "bt_core/cli/replay/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bt_core/analysis/load_recording.h"
#include "bt_core/cli/replay/scrubber.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/nodes/user_control.h"
#include "bt_core/record/recorder.h"
#include "tests/bt_core/analysis/recorded_run.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)

constexpr char kTree[] =
    "<BehaviorTree ID='Main'><ReactiveSequence name='root'><ScriptCondition name='ready' "
    "code='n &lt; 3'/><Sleep name='first' msec='1500'/><AlwaysSuccess name='second'/>"
    "</ReactiveSequence></BehaviorTree>";

class ReplayTest : public ::testing::Test {
 protected:
  ReplayTest() { Record(path(), 5); }

  // Ticks at 0, 1, 2 seconds.
  void Record(const std::string& file, double at_the_end) {
    SimulatedClock clock(100s);
    Executor executor(CompileText(kTree, std::make_shared<Registry>()), clock);
    EventStream stream(executor);
    RecorderOptions options;
    options.metadata = {{"robot", "sobi-1"}};
    Recorder recorder(stream, file, options);
    const Sender<double> n = executor.Writer<double>("n");
    n.Send(1);
    executor.Tick();
    clock.Advance(1s);
    executor.Tick();
    clock.Advance(1s);
    n.Send(at_the_end);
    executor.Tick();
    stream.Flush();
    recorder.Note(clock.Now(), "fault", "laser unplugged");
    EXPECT_EQ(recorder.Close().problem(), "");
  }

  std::string path() const { return folder_.Path("run.coppice"); }

  int Run(const std::vector<std::string>& arguments, int (*verb)(const std::vector<std::string>&)) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    const int status = verb(arguments);
    out_ = ::testing::internal::GetCapturedStdout();
    error_ = ::testing::internal::GetCapturedStderr();
    return status;
  }
  int Run(const std::vector<std::string>& arguments) { return Run(arguments, RunReplay); }

  const TemporaryFolder folder_;
  std::string out_;
  std::string error_;
};

TEST_F(ReplayTest, PrintsWhatHappened) {
  EXPECT_EQ(Run({path(), "--print"}), 0);
  EXPECT_THAT(out_, HasSubstr("tree Main: 4 nodes"));
  EXPECT_THAT(out_, HasSubstr("robot: sobi-1\n"));
  EXPECT_THAT(out_, HasSubstr("      0.000000  tick 1  first  IDLE -> RUNNING\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  note [fault] laser unplugged\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  tick 3  Main{n} = 5\n"));
  EXPECT_THAT(out_, HasSubstr("      2.000000  tick 3  first  RUNNING -> IDLE\n"));
  EXPECT_THAT(out_, HasSubstr("end of the record, after tick 3"));
  EXPECT_EQ(error_, "");
}

TEST_F(ReplayTest, ShowsOnlyWhatIsAskedFor) {
  EXPECT_EQ(Run({path(), "--node", "rea*"}), 0);
  EXPECT_THAT(out_, HasSubstr("ready  IDLE -> SUCCESS"));
  EXPECT_THAT(out_, Not(HasSubstr("first  IDLE")));
  EXPECT_EQ(Run({path(), "--from", "0.5", "--to", "1.5"}), 0);
  EXPECT_THAT(out_, Not(HasSubstr("tick 1 ")));
  EXPECT_THAT(out_, Not(HasSubstr("tick 3 ")));
}

TEST_F(ReplayTest, ShowsTheTreeAtATick) {
  EXPECT_EQ(Run({path(), "--tick", "2"}), 0);
  EXPECT_EQ(out_,
            "tick 2 at 1.000000 s: RUNNING\n"
            "RUNNING  root  <ReactiveSequence>\n"
            "SUCCESS    ready  <ScriptCondition>\n"
            "RUNNING    first  <Sleep>\n"
            "-          second  <AlwaysSuccess>\n"
            "Main{n} = 1\n");
  EXPECT_EQ(Run({path(), "--at", "1.5", "--json"}), 0);
  EXPECT_EQ(json::parse(out_)["tick"], 2);
  EXPECT_EQ(json::parse(out_)["nodes"]["first"]["status"], "RUNNING");
  EXPECT_EQ(Run({path(), "--tick", "9"}), 2);
  EXPECT_THAT(error_, HasSubstr("ends with tick 3"));
}

TEST_F(ReplayTest, SaysWhyAndWhyNot) {
  EXPECT_EQ(Run({path(), "--why", "root"}), 0);
  EXPECT_THAT(out_, HasSubstr(R"("root" is FAILURE after tick 3)"));
  EXPECT_THAT(out_,
              HasSubstr("ready  FAILURE (was SUCCESS)  code=\"n < 3\" is false: n = 5 (was 1)"));
  EXPECT_EQ(Run({path(), "--why-not", "first"}), 0);
  EXPECT_THAT(out_, HasSubstr(R"(why not: "root" did not reach "first", because "ready", )"
                              R"(which comes before it, is FAILURE)"));
  EXPECT_EQ(Run({path(), "--why-not", "ready"}), 1);
  EXPECT_EQ(Run({path(), "--why", "ready", "--tick", "1", "--json"}), 0);
  EXPECT_EQ(json::parse(out_)["steps"][1]["script"]["values"][0]["value"], 1.0);
  EXPECT_EQ(Run({path(), "--why", "raedy"}), 2);
  EXPECT_THAT(error_, HasSubstr("did you mean \"ready\"?"));
}

TEST_F(ReplayTest, VerifiesAndCompares) {
  EXPECT_EQ(Run({"--verify", path()}), 0) << out_ << error_;
  EXPECT_THAT(out_, HasSubstr("3 ticks, 11 events: the same\n"));
  const std::string other = folder_.Path("other.coppice");
  Record(other, 2);
  EXPECT_EQ(Run({"--diff", path(), other}), 1);
  EXPECT_THAT(out_, HasSubstr("the runs part in tick 3 (2.000000 s)"));
  EXPECT_EQ(Run({"--diff", path(), path()}), 0);
}

TEST_F(ReplayTest, SaysWhereARecordIsCutOff) {
  const std::string bytes = ReadFile(path());
  const std::string torn = folder_.Path("torn.coppice");
  WriteFile(torn, bytes.substr(0, bytes.size() - 1));
  EXPECT_EQ(Run({torn, "--print"}), 1);
  EXPECT_THAT(out_, HasSubstr("not closed"));
}

TEST_F(ReplayTest, RefusesWrongUsageAndOtherFiles) {
  EXPECT_EQ(Run({}), 2);
  EXPECT_THAT(error_, HasSubstr("expected FILE"));
  EXPECT_EQ(Run({path(), path()}), 2);
  EXPECT_EQ(Run({path(), "--form", "1"}), 2);
  EXPECT_EQ(Run({path(), "--from", "noon"}), 2);
  EXPECT_EQ(Run({path(), "--tick", "-1"}), 2);
  WriteFile(folder_.Path("text"), "not a record at all");
  EXPECT_EQ(Run({folder_.Path("text")}), 2);
  EXPECT_NE(error_, "");
}

TEST_F(ReplayTest, HasFiguresPerNode) {
  EXPECT_EQ(Run({path(), "--json"}, RunStats), 0);
  EXPECT_EQ(json::parse(out_)["nodes"][3]["ticks"], 0);
  EXPECT_EQ(Run({path(), "--sort", "ticks"}, RunStats), 0);
  EXPECT_THAT(out_, HasSubstr("3 ticks in 2.00 s"));
  EXPECT_EQ(Run({path(), "--sort", "size"}, RunStats), 2);
}

TEST_F(ReplayTest, IsConvertedByTheEndingsOfNames) {
  for (const char* name : {"x.json", "x.csv", "x.btlog", "x.bag", "x.coppice", "x.xml"}) {
    EXPECT_EQ(Run({path(), folder_.Path(name)}, RunConvert), 0) << error_;
    EXPECT_GT(ReadFile(folder_.Path(name)).size(), 100u) << name;
  }
  EXPECT_EQ(Run({folder_.Path("x.btlog"), folder_.Path("y.coppice")}, RunConvert), 0) << error_;
  EXPECT_EQ(Run({folder_.Path("y.coppice"), "--print"}), 0);
  EXPECT_THAT(out_, HasSubstr("first  IDLE -> RUNNING"));
  EXPECT_EQ(Run({"--verify", folder_.Path("x.coppice")}), 0);
  EXPECT_THAT(ReadFile(folder_.Path("x.xml")), HasSubstr("<Sleep name='first'"));
  EXPECT_EQ(Run({path(), folder_.Path("x.doc")}, RunConvert), 2);
  EXPECT_THAT(error_, HasSubstr("expected .coppice, .btlog, .json, .csv, .bag or .xml"));
  EXPECT_EQ(ReadFile(folder_.Path("x.doc")), "");
  EXPECT_EQ(Run({folder_.Path("none.btlog"), folder_.Path("z.csv")}, RunConvert), 2);
}

TEST_F(ReplayTest, SaysHowALogOfBehaviorTreeCppBecomesARecord) {
  const std::string log = folder_.Path("x.btlog");
  ASSERT_EQ(Run({path(), log}, RunConvert), 0);
  const std::string hint = "coppice convert " + log + " " + folder_.Path("x.coppice");
  for (const auto& verb : {RunReplay, RunStats}) {
    EXPECT_EQ(Run({log}, verb), 2);
    EXPECT_THAT(error_, HasSubstr(hint));
    EXPECT_EQ(Run({folder_.Path("none.btlog")}, verb), 2);
    EXPECT_THAT(error_, Not(HasSubstr("convert"))) << "there is no log";
  }
}

TEST_F(ReplayTest, GoesBackAndForthByKeys) {
  Diagnostics diagnostics;
  const std::optional<Recording> run = LoadRecording(path(), diagnostics);
  ASSERT_TRUE(run);
  Scrubber scrubber(*run);
  const auto press = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys) EXPECT_TRUE(scrubber.Press(key));
    return scrubber.entry();
  };
  EXPECT_EQ(scrubber.entry(), 2u);
  EXPECT_EQ(press({"left"}), 1u);
  EXPECT_EQ(press({"home", "home"}), 0u);
  EXPECT_EQ(press({"g", "9", "backspace", "2", "enter"}), 1u);
  EXPECT_EQ(press({"t", "0", ".", "5", "enter"}), 0u);
  EXPECT_EQ(press({"j", "n"}), 2u) << "\"ready\" fails there";
  EXPECT_EQ(press({"/", "s", "e", "c", "enter"}), 2u);
  EXPECT_EQ(scrubber.node(), 3u);
  press({"w"});
  EXPECT_THAT(scrubber.Render(40, 200), HasSubstr(R"("root" did not reach "second")"));
  EXPECT_THAT(scrubber.Render(40, 200), HasSubstr("tick 3 of 3"));
  press({"g", "x", "enter"});
  EXPECT_THAT(scrubber.Render(40, 200), HasSubstr("\"x\" is no number"));
  EXPECT_NE(scrubber.Render(1, 1), "");
  EXPECT_FALSE(scrubber.Press("q"));
}

TEST_F(ReplayTest, ARecordBecomesATestThatTheTestVerbPlays) {
  const std::string tree = folder_.Path("tree.xml");
  std::ofstream(tree) << "<root BTCPP_format='4' main_tree_to_execute='Main'>" << kTree
                      << "</root>";
  const std::string test = folder_.Path("night.test.json");
  EXPECT_EQ(Run({path(), "--scenario", test}), 2) << "the robot's path is not one here";
  EXPECT_THAT(error_, HasSubstr("--tree-file says where"));
  EXPECT_EQ(Run({path(), "--scenario", test, "--tree-file", tree, "--name", "night"}), 0) << error_;
  EXPECT_THAT(out_, HasSubstr("\"night\", 2 steps from tick 1")) << "nothing is new in tick 2";
  EXPECT_EQ(Run({test}, RunTest), 0) << out_;
  EXPECT_EQ(Run({path(), "--scenario", test, "--tree-file", tree, "--name", "night"}), 1);
  EXPECT_THAT(error_, HasSubstr("there is a scenario \"night\" already"));

  std::string changed = kTree;
  changed.replace(changed.find("1500"), 4, "2500");
  changed.replace(changed.find("n &lt; 3"), 8, "n &lt; 9");
  std::ofstream(tree) << "<root BTCPP_format='4' main_tree_to_execute='Main'>" << changed
                      << "</root>";
  EXPECT_EQ(Run({test}, RunTest), 1);
  EXPECT_THAT(out_, HasSubstr("step 2: status of the tree\n    expected FAILURE"));
}

TEST_F(ReplayTest, APartOfARecordBecomesATest) {
  const std::string tree = folder_.Path("tree.xml");
  std::ofstream(tree) << "<root BTCPP_format='4' main_tree_to_execute='Main'>" << kTree
                      << "</root>";
  const std::string test = folder_.Path("part.test.json");
  EXPECT_EQ(Run({path(), "--scenario", test, "--tree-file", tree, "--to", "1"}), 0) << error_;
  EXPECT_THAT(out_, HasSubstr("2 steps"));
  EXPECT_EQ(Run({path(), "--scenario", test, "--tree-file", tree, "--to", "soon"}), 2);
}

// Only the robot's program knows it; it adds nothing to what its child does.
class Guarded final : public UserDecorator {
 public:
  static constexpr const char* kDescription = "Ticks its child while the robot is safe.";
  Status Tick(Children& child, bool) override { return child.Tick(0); }
};

TEST_F(ReplayTest, ATestOfATreeWithADecoratorOfTheRobotsOwnNamesItsModel) {
  const std::string text =
      "<BehaviorTree ID='Main'><Guarded><Sleep name='first' msec='1500'/></Guarded></BehaviorTree>";
  const std::string guarded = folder_.Path("guarded.coppice");
  {
    SimulatedClock clock(100s);
    auto registry = std::make_shared<Registry>();
    registry->Register<Guarded>("Guarded");
    Executor executor(CompileText(text, registry), clock);
    EventStream stream(executor);
    Recorder recorder(stream, guarded, RecorderOptions());
    for (int i = 0; i < 3; ++i) {
      executor.Tick();
      clock.Advance(1s);
    }
    stream.Flush();
    EXPECT_EQ(recorder.Close().problem(), "");
  }
  const std::string tree = folder_.Path("tree.xml");
  std::ofstream(tree) << "<root BTCPP_format='4' main_tree_to_execute='Main'>" << text << "</root>";
  const std::string test = folder_.Path("night.test.json");
  EXPECT_EQ(Run({guarded, "--scenario", test, "--tree-file", tree}), 0) << error_;
  EXPECT_THAT(ReadFile(test), HasSubstr("\"models\": \"night.models.xml\""));
  EXPECT_EQ(Run({test}, RunTest), 0) << out_ << error_;

  const std::string mine = folder_.Path("mine.xml");
  std::filesystem::copy(folder_.Path("night.models.xml"), mine);
  const std::string other = folder_.Path("other.test.json");
  EXPECT_EQ(Run({guarded, "--scenario", other, "--tree-file", tree, "--models", mine}), 0);
  EXPECT_THAT(ReadFile(other), HasSubstr("\"models\": \"mine.xml\""));
  EXPECT_EQ(Run({other}, RunTest), 0) << out_ << error_;
}

}  // namespace
}  // namespace coppice
