#include "editor/simulation/scenario_tests.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace coppice::editor {
namespace {

using State = ScenarioTest::State;

class ScenarioTestsTest : public testing::Test {
 protected:
  ScenarioTestsTest() {
    folder_ = testing::TempDir() + "scenario_tests_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + "/";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    tree_ = Write("a.xml",
                  R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Go/></BehaviorTree></root>)");
    test_ = Write("a.test.json",
                  "{\"tree\": \"a.xml\", \"leaves\": {\"<Go>\": \"SUCCESS\"}, \"scenarios\": [\n"
                  " {\"name\": \"good\", \"steps\": [{\"expect\": {\"status\": \"SUCCESS\"}}]},\n"
                  R"( {"name": "bad", "steps": [{"expect": {"status": "FAILURE"}}]}]})");
  }
  ~ScenarioTestsTest() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + name) << text;
    return folder_ + name;
  }
  std::string States() const {
    std::string text;
    for (const ScenarioTest& test : tests_.all()) {
      static const char* const kNames[] = {"not run", "passed", "failed", "broken"};
      text += test.name + ": " + kNames[static_cast<int>(test.state)] + "\n";
    }
    return text;
  }

  std::string folder_;
  std::string tree_;
  std::string test_;
  OpenProject files_;
  ScenarioTests tests_;
};

TEST_F(ScenarioTestsTest, AreThoseBesideTheOpenFiles) {
  tests_.Look({tree_});
  EXPECT_EQ(States(), "good: not run\nbad: not run\n");
  EXPECT_EQ(tests_.all()[1].where.line, 3U);
  EXPECT_EQ(tests_.all()[1].tree_file, tree_);
}

TEST_F(ScenarioTestsTest, SayWhereSomethingDiffers) {
  tests_.Look({tree_});
  tests_.Run(files_, "*");
  EXPECT_EQ(States(), "good: passed\nbad: failed\n");
  ASSERT_EQ(tests_.all()[1].differences.size(), 1U);
  EXPECT_EQ(tests_.all()[1].differences[0].where.line, 3U);
  EXPECT_EQ(tests_.Count(State::kFailed), 1U);
  tests_.Look({tree_});
  EXPECT_EQ(States(), "good: passed\nbad: failed\n") << "what is known stays";
}

TEST_F(ScenarioTestsTest, ArePlayedOnTheTextInMemory) {
  tests_.Look({tree_});
  Diagnostics diagnostics;
  files_.Open(tree_, diagnostics);
  files_.SetText(tree_, "Type",
                 R"(<root BTCPP_format="4"><BehaviorTree ID="Main"><Inverter><Go/></Inverter>)"
                 "</BehaviorTree></root>");
  tests_.Run(files_, "*");
  EXPECT_EQ(States(), "good: failed\nbad: passed\n");
  files_.SetText(tree_, "Type", "<root");
  tests_.Run(files_, "good");
  EXPECT_EQ(States(), "good: broken\nbad: passed\n");
  EXPECT_NE(tests_.all()[0].problem.find("a.xml:1:"), std::string::npos);
}

TEST_F(ScenarioTestsTest, AFileThatCannotBeReadIsListedToo) {
  Write("b.test.json", "{\n \"tre\": \"a.xml\"}");
  tests_.Look({tree_});
  EXPECT_EQ(tests_.Count(State::kBroken), 1U);
  EXPECT_EQ(tests_.all().back().where.line, 2U);
}

TEST_F(ScenarioTestsTest, AScenarioIsSavedBesideItsTree) {
  Scenario scenario;
  scenario.name = "new";
  scenario.leaves = {{{}, {"<Go>", {}}}};
  scenario.steps.resize(1);
  Diagnostics diagnostics;
  EXPECT_EQ(SaveScenario(scenario, tree_, "", {}, "", diagnostics), test_);
  EXPECT_EQ(SaveScenario(scenario, tree_, "Main", {}, "", diagnostics),
            folder_ + "a.Main.test.json");
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.ToString();
  EXPECT_EQ(SaveScenario(scenario, tree_, "", {}, "", diagnostics), "") << "the name is taken";
  EXPECT_TRUE(diagnostics.has_errors());
  tests_.Look({tree_});
  tests_.Run(files_, "new");
  EXPECT_EQ(States(), "new: passed\ngood: not run\nbad: not run\nnew: passed\n");
}

// Everything that a file may have besides, in somebody's own hand.
constexpr char kOwnHand[] = R"(// how it goes
{
  "random" : { "set": {"stops": [1,2 , 3]},   // outputs
     "leaves": {"<Go>": {"chances": {"SUCCESS": 3, "FAILURE": 1, "holds_ms": [0, 500]},
                         "outputs": {"rung": [0, 1]}}},
     "lasts_ms": 60000.5 },
  "tree": "./a.xml",
  "leaves": {"<Go>": "SUCCESS"},
  "scenarios": [
    { "name": "good", "steps": [{}] } /* the last */
  ] }

)";

TEST_F(ScenarioTestsTest, SavingAScenarioLeavesAllElseOfTheFileAsItIs) {
  Write("a.test.json", kOwnHand);
  Scenario scenario;
  scenario.name = "new";
  scenario.steps.resize(1);
  Diagnostics diagnostics;
  ASSERT_EQ(SaveScenario(scenario, tree_, "", {}, "", diagnostics), test_)
      << diagnostics.ToString();
  std::ifstream stream(test_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::string old = kOwnHand;
  const std::size_t at = old.find(" /* the last */");
  ASSERT_GT(text.size(), old.size());
  EXPECT_EQ(text.substr(0, at), old.substr(0, at));
  EXPECT_EQ(text.substr(text.size() - (old.size() - at)), old.substr(at));
  const auto suite = LoadScenarios(test_, diagnostics);
  ASSERT_TRUE(suite) << diagnostics.ToString();
  EXPECT_EQ(suite->scenarios.size(), 2U);
  EXPECT_EQ(suite->random->lasts, std::chrono::microseconds(60000500));
}

}  // namespace
}  // namespace coppice::editor
