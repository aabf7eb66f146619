#include "bt_core/testing/random_suite.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/bt_core/testing/with_stand_ins.h"

namespace coppice {
namespace {

class RandomSuiteTest : public testing::Test {
 protected:
  RandomSuiteTest() {
    folder_ = testing::TempDir() + "random_suite_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + "/";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    tree_ = Write("patrol.xml", R"(<root BTCPP_format="4"/>)");
  }
  ~RandomSuiteTest() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + name) << text;
    return folder_ + name;
  }
  // `about`: members that say what the scenarios are about.
  std::string WriteSuite(const std::string& name, const std::string& about,
                         const std::string& random) const {
    return Write(name, "{" + about + ",\n" +
                           (random.empty() ? "" : R"( "random": )" + random + ",") +
                           "\n\"scenarios\": [{\"name\": \"a\", \"steps\": [{}]}]}");
  }
  std::optional<ScenarioSuite> Beside(const std::string& id, bool is_main) {
    return RandomSuiteBeside(tree_, id, is_main, diagnostics_);
  }

  std::string folder_;
  std::string tree_;
  Diagnostics diagnostics_;
};

TEST_F(RandomSuiteTest, ATreeHasItsScenariosBesideIt) {
  EXPECT_EQ(ScenarioFileOf("a/patrol.xml", ""), "a/patrol.test.json");
  EXPECT_EQ(ScenarioFileOf("a/patrol.xml", "Dock"), "a/patrol.Dock.test.json");
}

TEST_F(RandomSuiteTest, WithoutAFileNothingIsSaid) {
  const auto suite = Beside("Patrol", true);
  ASSERT_TRUE(suite);
  EXPECT_EQ(suite->file, "");
  EXPECT_EQ(suite->tree_id, "Patrol");
  EXPECT_EQ(suite->random->where.file, "");
  EXPECT_EQ(suite->random->lasts, Duration(0));
}

TEST_F(RandomSuiteTest, TheFileOfTheMainTreeIsThatOfTheTreeFile) {
  const std::string file =
      WriteSuite("patrol.test.json", R"("tree": "patrol.xml")", R"({"lasts_ms": 5})");
  const auto suite = Beside("Patrol", true);
  ASSERT_TRUE(suite);
  EXPECT_EQ(suite->file, file);
  EXPECT_EQ(suite->random->where.file, file);
  EXPECT_EQ(suite->random->where.line, 2U);
  EXPECT_EQ(suite->random->lasts, std::chrono::milliseconds(5));
  EXPECT_EQ(Beside("Dock", false)->file, "") << "it is about the main tree";
  EXPECT_EQ(Beside("", true)->file, file);
}

TEST_F(RandomSuiteTest, ATreeThatIsNotTheMainOneHasAFileOfItsOwn) {
  const std::string about = R"("tree": "patrol.xml", "tree_id": "Dock")";
  const std::string of_all = WriteSuite("patrol.test.json", about, "{}");
  EXPECT_EQ(Beside("Dock", false)->file, of_all);
  EXPECT_EQ(Beside("Patrol", true)->file, "");
  const std::string own = WriteSuite("patrol.Dock.test.json", about, "{}");
  EXPECT_EQ(Beside("Dock", false)->file, own);
}

TEST_F(RandomSuiteTest, ScenariosOfAnotherFileOrWithoutChanceDoNotCount) {
  Write("other.xml", R"(<root BTCPP_format="4"/>)");
  WriteSuite("patrol.test.json", R"("tree": "other.xml")", "{}");
  EXPECT_EQ(Beside("Patrol", true)->file, "");
  WriteSuite("patrol.test.json", R"("tree": "patrol.xml")", "");
  EXPECT_EQ(Beside("Patrol", true)->file, "");
  EXPECT_FALSE(diagnostics_.has_errors());
}

TEST_F(RandomSuiteTest, AnErrorIsSaidWithItsPlace) {
  WriteSuite("patrol.test.json", R"("tree": "patrol.xml")", R"({"last_ms": 5})");
  EXPECT_FALSE(Beside("Patrol", true));
  EXPECT_NE(diagnostics_.ToString().find("patrol.test.json:2:24: error: "), std::string::npos)
      << diagnostics_.ToString();
}

TEST_F(RandomSuiteTest, KeysAreHeldAgainstTheTree) {
  const auto program = CompileWithStandIns(
      R"(<root BTCPP_format="4"><BehaviorTree ID="M"><Repeat num_cycles="{stops}"><Go/>)"
      "</Repeat></BehaviorTree></root>",
      diagnostics_);
  ASSERT_TRUE(program) << diagnostics_.ToString();
  const auto number = [](const char* key, const char* text) {
    return KeyValue{{"a.test.json", 3, 7}, key, text, KeyValue::Kind::kNumber};
  };
  RandomPlay play;
  play.set = {{number("stops", "1"), number("stops", "2")}};
  EXPECT_TRUE(CheckPlay(*program, play, diagnostics_));
  play.set = {{number("stop", "1")}, {number("stops", "1"), number("stops", "many")}};
  EXPECT_FALSE(CheckPlay(*program, play, diagnostics_));
  const std::string said = diagnostics_.ToString();
  EXPECT_NE(said.find(R"(a.test.json:3:7: error: the tree has no key "stop")"), std::string::npos)
      << said;
  EXPECT_NE(said.find(R"("many" is no value of type)"), std::string::npos) << said;
}

}  // namespace
}  // namespace coppice
